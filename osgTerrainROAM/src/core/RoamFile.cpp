// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <fstream>
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

constexpr std::size_t kMostRoamFileBytes = 1 << 20; ///< a larger file is not a .roam text

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

} // namespace

Result<RoamFile> parseRoamFile(std::string_view text, const std::filesystem::path& name)
{
    RoamFile file;
    std::set<std::string, std::less<>> seen;
    std::size_t line = 0;
    for (std::size_t at = 0; at < text.size();)
    {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string_view content = text.substr(at, end - at);
        at = end + 1;
        ++line;
        content = trimmed(content.substr(0, content.find('#')));
        if (content.empty()) continue;
        RoamEntry entry{name.string() + ":" + std::to_string(line), {}, {}, name.parent_path()};
        const std::size_t equals = content.find('=');
        if (equals == std::string_view::npos || content.find('\0') != std::string_view::npos)
            return entry.error("not of the form key = value", "see the keys: " + roamKeyNames());
        entry.key = trimmed(content.substr(0, equals));
        entry.value = trimmed(content.substr(equals + 1));
        if (!seen.emplace(entry.key).second && !repeatsInRoamFile(entry.key))
            return entry.error("'" + std::string(entry.key) + "' stands here a second time",
                               "keep one of them");
        if (const auto assigned = assignRoamEntry(file, entry); !assigned) return assigned.error();
    }
    if (file.dems.empty())
        return Error{name.string() + ":" + std::to_string(line + 1), "no dem is named",
                     "add a line dem = FILE"};
    return file;
}

Result<RoamFile> readRoamFile(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return Error{file.string(), "cannot be read", "check the path and its permissions"};
    std::string text(kMostRoamFileBytes + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
    if (text.size() > kMostRoamFileBytes || text.find('\0') != std::string::npos)
        return Error{file.string(), "is no .roam text", "a .roam file holds lines key = value"};

    const auto parsed = parseRoamFile(text, file);
    if (!parsed) return parsed;
    for (const NamedFile& named : namedFiles(*parsed))
    {
        std::error_code ignored;
        if (named.path.empty() || named.path.string().starts_with("/vsi") ||
            std::filesystem::exists(named.path, ignored))
            continue;
        return Error{placeOfKey(text, named, file),
                     std::string(named.key) + " '" + foundation::excerpt(named.path.string()) +
                         "' does not exist",
                     "paths are relative to the .roam file"};
    }
    return parsed;
}

} // namespace osgTerrainROAM::core
