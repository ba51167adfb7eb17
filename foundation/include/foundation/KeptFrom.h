// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include <foundation/ContentMark.h>
#include <foundation/KeptResults.h>
#include <foundation/SoleFile.h>

namespace foundation
{

/// Kept results that all follow from something whose mark is known, as the ground of a scene, and each from
/// more.
/// Ownership: shares the results with its copies. Threads: as KeptResults.
class KeptFrom
{
public:
    /// Keeps nothing and finds nothing.
    KeptFrom() = default;

    /// `mark`: of what all results follow from; absent, or `results` null: nothing is kept.
    KeptFrom(std::shared_ptr<const KeptResults> results, const std::optional<ContentMark>& mark)
        : _results(mark ? std::move(results) : nullptr), _mark(mark.value_or(ContentMark()))
    {
    }

    /// Those of the user who runs the program (KeptResults::ofUser()).
    static KeptFrom ofUser(const std::optional<ContentMark>& mark)
    {
        return KeptFrom(std::shared_ptr<const KeptResults>(new KeptResults(KeptResults::ofUser())), mark);
    }

    explicit operator bool() const { return _results != nullptr; }

    /// Those that follow from the program alone, and from what is asked for.
    KeptFrom withoutMark() const { return KeptFrom(_results, ContentMark()); }

    /// As KeptResults::findOrMake(); `more`: what the result follows from besides.
    template<class Read, class Make, class Write>
    auto findOrMake(std::string_view name, const ContentMark& more, const Read& read, const Make& make,
                    const Write& write) const -> decltype(make())
    {
        if (!_results) return make();
        return _results->findOrMake(name, ContentMark(_mark).add(more.text()), read, make, write);
    }

    /// The same of what is read of a file, which counts with what lies beside it (markOfSoleFile()); a file
    /// that has no mark is read each time. `more`: what the result follows from besides.
    template<class Read, class Make, class Write>
    auto findOrRead(std::string_view name, const std::filesystem::path& file, const ContentMark& more,
                    const Read& read, const Make& make, const Write& write) const -> decltype(make())
    {
        auto mark = _results ? markOfSoleFile(file) : std::nullopt;
        return mark ? findOrMake(name, mark->add(more.text()), read, make, write) : make();
    }

private:
    std::shared_ptr<const KeptResults> _results;
    ContentMark _mark;
};

} // namespace foundation
