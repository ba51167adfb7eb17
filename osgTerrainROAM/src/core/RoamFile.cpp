// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>
#include <system_error>
#include <vector>

#include <foundation/Excerpt.h>

#include <osgTerrainROAM/core/RoamFile.h>

#include "RoamKeys.h"
#include "TextLines.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Result;

/// A file that a key names: the `nth` line with this key.
struct NamedFile
{
    std::string_view key;
    std::filesystem::path path;
    int nth = 0;
};

std::vector<NamedFile> namedFiles(const RoamFile& file)
{
    std::vector<NamedFile> named{{"land_cover", file.landCover}, {"roads", file.roads}};
    if (file.landCoverClasses != "worldcover" && file.landCoverClasses != "corine")
        named.push_back({"land_cover_classes", file.landCoverClasses});
    const auto append = [&](std::string_view key, const std::vector<std::filesystem::path>& paths)
    {
        for (std::size_t i = 0; i < paths.size(); ++i)
            named.push_back({key, paths[i], static_cast<int>(i)});
    };
    append("dem", file.dems);
    append("imagery", file.imagery);
    append("features", file.features);
    append("buildings", file.buildings);
    append("objects", file.objects);
    append("structures", file.structures);
    append("earthworks", file.earthworks);
    return named;
}

/// Line (from 1) of a key in text that has been parsed before.
std::string placeOfKey(std::string_view text, const NamedFile& named, const std::filesystem::path& name)
{
    std::size_t line = 1;
    int before = named.nth;
    for (std::size_t at = 0; at < text.size(); ++line)
    {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view content = text.substr(at, end - at);
        if (trimmed(content.substr(0, content.find('='))) == named.key && before-- == 0) break;
        at = end + 1;
    }
    return name.string() + ":" + std::to_string(line);
}

/// The number of lines of a text, of which the last may lack its end.
std::ptrdiff_t linesOf(std::string_view text)
{
    return std::ranges::count(text, '\n') + (!text.empty() && text.back() != '\n');
}

} // namespace

Result<RoamFile> parseRoamFile(std::string_view text, const std::filesystem::path& name)
{
    RoamFile file;
    std::set<std::string, std::less<>> seen;
    const auto read =
        visitEntries(text, name, roamKeyNames(),
                     [&](const RoamEntry& entry) -> foundation::Outcome
                     {
                         if (!seen.emplace(entry.key).second && !repeatsInRoamFile(entry.key))
                             return entry.error("'" + std::string(entry.key) + "' stands here a second time",
                                                "keep one of them");
                         return assignRoamEntry(file, entry);
                     });
    if (!read) return read.error();
    if (file.dems.empty())
        return Error{name.string() + ":" + std::to_string(1 + linesOf(text)), "no dem is named",
                     "add a line dem = FILE"};
    return file;
}

Result<RoamFile> readRoamFile(const std::filesystem::path& file)
{
    const auto text = readEntries(file);
    if (!text) return text.error();
    const auto parsed = parseRoamFile(*text, file);
    if (!parsed) return parsed;
    for (const NamedFile& named : namedFiles(*parsed))
    {
        std::error_code ignored;
        if (named.path.empty() || named.path.string().starts_with("/vsi") ||
            std::filesystem::exists(named.path, ignored))
            continue;
        return Error{placeOfKey(*text, named, file),
                     std::string(named.key) + " '" + foundation::excerpt(named.path.string()) +
                         "' does not exist",
                     "paths are relative to the .roam file"};
    }
    return parsed;
}

} // namespace osgTerrainROAM::core
