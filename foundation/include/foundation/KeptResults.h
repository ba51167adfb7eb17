// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include <foundation/CacheFolder.h>
#include <foundation/ContentMark.h>
#include <foundation/MappedFile.h>
#include <foundation/ProgramMark.h>
#include <foundation/WholeFile.h>
#include <unistd.h>

namespace foundation
{

/// Results of long computations, kept in a folder, each in a file of its own that is named by a mark of what
/// it follows from: the program and its libraries, and the computation's inputs. So a result is found only
/// where computing it again would give the same bytes. A file that is missing, cut off or damaged is no
/// result; keeping the result anew replaces it, and a line tells of a damaged one. What cannot be written is
/// not kept, which is no error.
/// Memory: a folder holds up to `mostBytes` and a sixty-fourth, and one file a quarter of that; what was not
/// asked for the longest time is removed first.
/// Threads: any number, in any number of processes.
class KeptResults
{
public:
    static constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30;

    /// Keeps nothing and finds nothing.
    KeptResults() = default;

    /// Takes a line for a person.
    using Teller = void (*)(const std::string& line);

    /// `program`: of those that make the results; absent: nothing is kept. `tell`: called from any thread
    /// that finds a damaged file; null: nobody is told.
    explicit KeptResults(std::filesystem::path folder,
                         const std::optional<ContentMark>& program = ProgramMark::ofThis(),
                         std::uintmax_t mostBytes = kMostBytes, Teller tell = nullptr)
        : _folder(program ? std::move(folder) : std::filesystem::path()),
          _program(program.value_or(ContentMark())),
          _mostBytes(mostBytes),
          _tell(tell)
    {
    }

    /// Those of the user who runs the program: "made" in cacheFolder(). Damage is told on standard error.
    static KeptResults ofUser()
    {
        // Once: drivers and plugins that are loaded later are no part of the program.
        static const std::optional<ContentMark> program = ProgramMark::ofThis();
        const std::filesystem::path cache = cacheFolder();
        return cache.empty()
                   ? KeptResults()
                   : KeptResults(cache / "made", program, kMostBytes,
                                 [](const std::string& line) { std::fputs((line + '\n').c_str(), stderr); });
    }

    /// Returns the bytes kept under a name and a mark of the inputs.
    std::optional<std::string> find(std::string_view name, const ContentMark& inputs) const
    {
        const auto file = findFile(name, inputs);
        return file ? std::optional<std::string>(file->text().substr(kHeadBytes)) : std::nullopt;
    }

    void keep(std::string_view name, const ContentMark& inputs, std::string_view bytes) const
    {
        if (_folder.empty() || bytes.size() > mostBytesOfOne()) return;
        std::error_code failed;
        std::filesystem::create_directories(_folder, failed);
        if (failed) return;
        // Others may write the same result at once.
        const std::string ending = '.' + std::to_string(getpid()) + '-' + std::to_string(gettid()) + ".part";
        std::string text = headOf(bytes);
        text += bytes;
        (void)writeWholeFile(fileOf(name, inputs), text, ending); // one that cannot be kept is made again
        // Looking at each file of the folder is not for every file that is written.
        if ((_unchecked += text.size()) < _mostBytes / 64) return;
        _unchecked = 0;
        removeOldest();
    }

    /// Returns the result kept under a name and a mark of the inputs, or makes it and keeps it. `read`: takes
    /// the bytes as a string_view, and returns an optional that is absent where `write` did not write them;
    /// `write`: returns the bytes of a result; where it takes the greatest number of bytes besides, they are
    /// absent when there would be more. `make` may return a Result: failures are not kept.
    template<class Read, class Make, class Write>
    auto findOrMake(std::string_view name, const ContentMark& inputs, const Read& read, const Make& make,
                    const Write& write) const -> decltype(make())
    {
        if (const auto file = findFile(name, inputs))
        {
            if (auto found = read(file->text().substr(kHeadBytes))) return *std::move(found);
            tellDamage(fileOf(name, inputs));
        }
        auto made = make();
        if constexpr (requires { made.error(); })
        {
            if (made) keepMade(name, inputs, *made, write);
        }
        else
            keepMade(name, inputs, made, write);
        return made;
    }

private:
    static constexpr std::string_view kMagic = "osgTrainer kept 1\n";
    static constexpr std::size_t kHeadBytes = kMagic.size() + 33;

    struct Kept
    {
        std::filesystem::file_time_type used;
        std::uintmax_t bytes;
        std::filesystem::path file;
    };

    std::uintmax_t mostBytesOfOne() const { return _mostBytes / 4; }

    template<class Made, class Write>
    void keepMade(std::string_view name, const ContentMark& inputs, const Made& made,
                  const Write& write) const
    {
        if (_folder.empty()) return;
        if constexpr (std::is_invocable_v<Write, const Made&, std::uintmax_t>)
        {
            if (const auto bytes = write(made, mostBytesOfOne())) keep(name, inputs, *bytes);
        }
        else
            keep(name, inputs, write(made));
    }

    void tellDamage(const std::filesystem::path& file) const
    {
        if (_tell) _tell("note: the kept result " + file.string() + " is damaged and is made anew");
    }

    /// The mark of the contents tells damage.
    static std::string headOf(std::string_view bytes)
    {
        return std::string(kMagic) + ContentMark().add(bytes).text() + '\n';
    }

    /// Whole and undamaged; absent: there is none such. It is mapped: results of many megabytes are not
    /// copied once more.
    std::optional<MappedFile> findFile(std::string_view name, const ContentMark& inputs) const
    {
        if (_folder.empty()) return std::nullopt;
        const std::filesystem::path path = fileOf(name, inputs);
        auto file = MappedFile::open(path);
        if (!file) return std::nullopt;
        file->fetchAll();
        const std::string_view text = file->text();
        if (text.size() < kHeadBytes || text.substr(0, kHeadBytes) != headOf(text.substr(kHeadBytes)))
        {
            tellDamage(path);
            return std::nullopt;
        }
        std::error_code failed;
        std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now(), failed);
        return std::move(*file);
    }

    std::filesystem::path fileOf(std::string_view name, ContentMark inputs) const
    {
        return _folder / (std::string(name) + '-' + inputs.add(_program.text()).text());
    }

    void removeOldest() const
    {
        std::vector<Kept> all;
        std::uintmax_t bytes = 0;
        std::error_code failed;
        for (const auto& entry : std::filesystem::directory_iterator(_folder, failed))
        {
            const std::uintmax_t size = entry.file_size(failed);
            if (failed) continue;
            all.push_back({entry.last_write_time(failed), size, entry.path()});
            bytes += size;
        }
        if (bytes <= _mostBytes) return;
        std::sort(all.begin(), all.end(), [](const Kept& a, const Kept& b) { return a.used < b.used; });
        for (const Kept& kept : all)
        {
            if (bytes <= _mostBytes) return;
            if (std::filesystem::remove(kept.file, failed)) bytes -= kept.bytes;
        }
    }

    std::filesystem::path _folder;
    ContentMark _program;
    std::uintmax_t _mostBytes = kMostBytes;
    Teller _tell = nullptr;
    /// Written since removeOldest(); at first, by others.
    mutable std::atomic<std::uintmax_t> _unchecked = kMostBytes;
};

} // namespace foundation
