// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include <foundation/Result.h>

namespace osgPMObjects::core
{

/// Takes a `.pm` file apart into its sections, and looks at their check sums.
class PmSectionStream
{
public:
    struct Section
    {
        std::string letters, contents;
    };

    /// `place`: the stream's name in errors.
    PmSectionStream(std::istream& stream, std::string place) : _stream(stream), _place(std::move(place)) {}

    /// What is before the first section. Errors: not a progressive mesh, of another version.
    foundation::Outcome readBegin();

    /// Errors: cut off, or another check sum.
    foundation::Outcome read(Section& section);
    /// The contents of a section that has to be the next. Errors: besides, it is another one.
    foundation::Outcome read(std::string_view letters, std::string& contents);

    /// How many bytes there are from the begin on, if the stream can tell.
    std::optional<std::uint64_t> size() const { return _size; }

    /// An error where the stream is.
    foundation::Error damaged(const std::string& what) const;

private:
    std::string take(std::uint64_t count);

    std::istream& _stream;
    std::string _place;
    std::uint64_t _at = 0;
    std::optional<std::uint64_t> _size;
};

} // namespace osgPMObjects::core
