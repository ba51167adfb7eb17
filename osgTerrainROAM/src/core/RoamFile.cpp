// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <set>
#include <system_error>
#include <vector>

#include <foundation/Excerpt.h>

#include <osgTerrainROAM/core/RoamFile.h>

#include "TextLines.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Outcome;
using foundation::Result;
using foundation::success;

constexpr std::size_t kMostRoamFileBytes = 1 << 20; ///< a larger file is not a .roam text

/// One line `key = value`, with the data that messages and relative paths need.
struct Entry
{
    std::string place; ///< file:line
    std::string_view key, value;
    std::filesystem::path folder;

    /// Returns an error of this line; of an overlong line it shows an excerpt.
    Error error(const std::string& what, const std::string& remedy) const
    {
        return {place, foundation::excerpt(what), remedy};
    }
};

Result<std::vector<double>> numbers(const Entry& entry, std::size_t least, std::size_t most)
{
    std::vector<double> found;
    const char* at = entry.value.data();
    const char* const end = at + entry.value.size();
    while (at != end)
    {
        if (*at == ' ' || *at == '\t')
        {
            ++at;
            continue;
        }
        double number = 0.0;
        const auto [next, failure] = std::from_chars(at, end, number);
        const bool ends = next == end || *next == ' ' || *next == '\t';
        if (failure != std::errc() || !ends || !std::isfinite(number))
            return entry.error("'" + std::string(entry.value) + "' is not a number that " +
                                   std::string(entry.key) + " can have",
                               "write plain decimal numbers");
        found.push_back(number);
        at = next;
    }
    if (found.size() < least || found.size() > most)
        return entry.error(std::string(entry.key) + " has " + std::to_string(found.size()) + " numbers",
                           "give " + std::to_string(least) +
                               (most > least ? " to " + std::to_string(most) : std::string()));
    return found;
}

/// Parses a number within [low, high].
Result<double> numberWithin(const Entry& entry, double low, double high)
{
    const auto found = numbers(entry, 1, 1);
    if (!found) return found.error();
    const double number = found->front();
    if (number < low || number > high)
        return entry.error(std::string(entry.key) + " = " + std::string(entry.value) + " is out of range",
                           "give a number from " + std::to_string(low) + " to " + std::to_string(high));
    return number;
}

template<class Target>
Outcome assignNumber(Target& target, const Entry& entry, double low, double high)
{
    const auto number = numberWithin(entry, low, high);
    if (!number) return number.error();
    target = *number;
    return success();
}

Outcome assignPath(std::filesystem::path& target, const Entry& entry)
{
    const std::filesystem::path path{std::string(entry.value)};
    target = path.is_absolute() ? path : entry.folder / path;
    return success();
}

Outcome assignOrigin(RoamFile& file, const Entry& entry)
{
    const auto found = numbers(entry, 2, 3);
    if (!found) return found.error();
    const auto& list = *found;
    if (std::abs(list[0]) > 90.0 || std::abs(list[1]) > 360.0)
        return entry.error("origin = " + std::string(entry.value) + " is no place on Earth",
                           "give latitude, longitude in degrees and perhaps the height in metres");
    file.origin = Geodetic{list[0], list[1], list.size() > 2 ? list[2] : 0.0};
    return success();
}

Outcome assignRoadsOrigin(RoamFile& file, const Entry& entry)
{
    const auto found = numbers(entry, 2, 3);
    if (!found) return found.error();
    const auto& list = *found;
    if (std::abs(list[0]) > 89.0 || std::abs(list[1]) > 360.0)
        return entry.error("roads_origin = " + std::string(entry.value) + " is no place for roads",
                           "give latitude and longitude in degrees, and perhaps the heading");
    file.roadsOrigin = RoadsOrigin{list[0], list[1], list.size() > 2 ? list[2] : 0.0};
    return success();
}

Outcome assignSun(RoamFile& file, const Entry& entry)
{
    const auto found = numbers(entry, 2, 2);
    if (!found) return found.error();
    if (std::abs((*found)[1]) > 90.0)
        return entry.error("the sun cannot stand " + std::to_string((*found)[1]) + " degrees high",
                           "give azimuth (clockwise from north) and elevation in degrees");
    file.sunAzimuthDeg = (*found)[0];
    file.sunElevationDeg = (*found)[1];
    return success();
}

Outcome unknownWord(const Entry& entry, const std::string& choices)
{
    return entry.error(std::string(entry.key) + " = '" + std::string(entry.value) + "' is unknown",
                       "use one of: " + choices);
}

/// A word, and the value it stands for.
template<class Value>
struct Word
{
    std::string_view text;
    Value value;
};

template<class Value, std::size_t Count>
Outcome assignWord(Value& target, const Entry& entry, const Word<Value> (&words)[Count])
{
    std::string choices;
    for (const Word<Value>& word : words)
    {
        if (word.text == entry.value)
        {
            target = word.value;
            return success();
        }
        choices += (choices.empty() ? "" : ", ") + std::string(word.text);
    }
    return unknownWord(entry, choices);
}

constexpr Word<Placement> kPlacements[] = {{"curved", Placement::curved}, {"planar", Placement::planar}};
/// What the values of `voids` mean.
struct VoidsWord
{
    Voids voids;
    bool shows;
};
constexpr Word<VoidsWord> kVoids[] = {
    {"fill", {Voids::fill, false}}, {"keep", {Voids::keep, false}}, {"show", {Voids::fill, true}}};
constexpr Word<bool> kRoadsHeights[] = {{"file", false}, {"ground", true}};
constexpr Word<bool> kWaters[] = {{"level", true}, {"none", false}};
constexpr Word<bool> kSurroundings[] = {{"made", true}, {"none", false}};
constexpr Word<VerticalDatum> kDatums[] = {{"automatic", VerticalDatum::automatic},
                                           {"egm96", VerticalDatum::egm96},
                                           {"ellipsoid", VerticalDatum::ellipsoid}};

Outcome assignVoids(RoamFile& file, const Entry& entry)
{
    VoidsWord word{Voids::fill, false};
    const Outcome assigned = assignWord(word, entry, kVoids);
    file.import.voids = word.voids;
    file.showsVoids = word.shows;
    return assigned;
}

Outcome assignTriangles(RoamFile& file, const Entry& entry)
{
    const auto number = numberWithin(entry, 2.0, 4.0e9);
    if (!number) return number.error();
    file.maxTriangles = static_cast<std::uint32_t>(*number);
    return success();
}

/// Resolves the path of a class table; the name of a built-in table stays as it is.
Outcome assignClasses(RoamFile& file, const Entry& entry)
{
    if (entry.value != "worldcover" && entry.value != "corine")
        return assignPath(file.landCoverClasses, entry);
    file.landCoverClasses = std::string(entry.value);
    return success();
}

Outcome assignSeason(RoamFile& file, const Entry& entry)
{
    constexpr std::array<std::string_view, 12> kMonths{"january",   "february", "march",    "april",
                                                       "may",       "june",     "july",     "august",
                                                       "september", "october",  "november", "december"};
    const auto month = std::find(kMonths.begin(), kMonths.end(), entry.value);
    if (month == kMonths.end() && std::isalpha(static_cast<unsigned char>(entry.value.front())))
        return unknownWord(entry, "january … december, or a share of the year from 0 to 1");
    if (month == kMonths.end()) return assignNumber(file.seasonOfYear, entry, 0.0, 1.0);
    file.seasonOfYear = (static_cast<double>(month - kMonths.begin()) + 0.5) / 12.0;
    return success();
}

Outcome appendPath(std::vector<std::filesystem::path>& target, const Entry& entry)
{
    return assignPath(target.emplace_back(), entry);
}

Outcome assignImagery(RoamFile& file, const Entry& entry)
{
    if (file.imagery.size() < RoamFile::kMaxImagery) return appendPath(file.imagery, entry);
    return entry.error("is one imagery more than the " + std::to_string(RoamFile::kMaxImagery) +
                           " that there may be",
                       "join some with gdalbuildvrt");
}

/// A key, and the function that applies its value.
struct Key
{
    std::string_view name;
    Outcome (*assign)(RoamFile&, const Entry&);
    bool repeats = false; ///< may appear in several lines
};

constexpr double kFar = 1.0e7; ///< metres; larger than the Earth's radius

constexpr std::array kKeys{
    Key{"dem", [](RoamFile& f, const Entry& e) { return appendPath(f.dems, e); }, true},
    Key{"voids", assignVoids},
    Key{"imagery", assignImagery, true},
    Key{"features", [](RoamFile& f, const Entry& e) { return appendPath(f.features, e); }, true},
    Key{"land_cover", [](RoamFile& f, const Entry& e) { return assignPath(f.landCover, e); }},
    Key{"land_cover_classes", assignClasses},
    Key{"season", assignSeason},
    Key{"roads", [](RoamFile& f, const Entry& e) { return assignPath(f.roads, e); }},
    Key{"roads_origin", assignRoadsOrigin},
    Key{"roads_heights",
        [](RoamFile& f, const Entry& e) { return assignWord(f.roadsOnGround, e, kRoadsHeights); }},
    Key{"origin", assignOrigin},
    Key{"placement", [](RoamFile& f, const Entry& e) { return assignWord(f.placement, e, kPlacements); }},
    Key{"spacing",
        [](RoamFile& f, const Entry& e) { return assignNumber(f.import.spacingM, e, 1e-3, kFar); }},
    Key{"vertical_datum",
        [](RoamFile& f, const Entry& e) { return assignWord(f.import.verticalDatum, e, kDatums); }},
    Key{"finest_spacing",
        [](RoamFile& f, const Entry& e) { return assignNumber(f.finestSpacingM, e, 0.01, 1000.0); }},
    Key{"error_tolerance",
        [](RoamFile& f, const Entry& e) { return assignNumber(f.errorTolerancePx, e, 1e-3, 1e3); }},
    Key{"max_triangles", assignTriangles},
    Key{"aridity", [](RoamFile& f, const Entry& e) { return assignNumber(f.land.aridity, e, 0.0, 1.0); }},
    Key{"tree_line",
        [](RoamFile& f, const Entry& e) { return assignNumber(f.land.treeLineM, e, -kFar, kFar); }},
    Key{"snow_line",
        [](RoamFile& f, const Entry& e) { return assignNumber(f.land.snowLineM, e, -kFar, kFar); }},
    Key{"sea_level",
        [](RoamFile& f, const Entry& e) { return assignNumber(f.land.seaLevelM, e, -kFar, kFar); }},
    Key{"water", [](RoamFile& f, const Entry& e) { return assignWord(f.land.hasWater, e, kWaters); }},
    Key{"sun", assignSun},
    Key{"surroundings",
        [](RoamFile& f, const Entry& e) { return assignWord(f.surroundings, e, kSurroundings); }},
    Key{"moonlight", [](RoamFile& f, const Entry& e) { return assignNumber(f.moonlight, e, 0.0, 1.0); }},
    Key{"visibility", [](RoamFile& f, const Entry& e) { return assignNumber(f.visibilityM, e, 1.0, kFar); }},
};

std::string keyNames()
{
    std::string names;
    for (const Key& key : kKeys)
        names += (names.empty() ? "" : ", ") + std::string(key.name);
    return names;
}

Outcome assignEntry(RoamFile& file, const Entry& entry)
{
    if (entry.value.empty())
        return entry.error(std::string(entry.key) + " has no value",
                           "write key = value, or take the line out");
    for (const Key& key : kKeys)
        if (key.name == entry.key) return key.assign(file, entry);
    return entry.error("unknown key '" + std::string(entry.key) + "'", "known keys: " + keyNames());
}

bool repeats(std::string_view name)
{
    return std::any_of(kKeys.begin(), kKeys.end(),
                       [=](const Key& key) { return key.name == name && key.repeats; });
}

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
        Entry entry{name.string() + ":" + std::to_string(line), {}, {}, name.parent_path()};
        const std::size_t equals = content.find('=');
        if (equals == std::string_view::npos || content.find('\0') != std::string_view::npos)
            return entry.error("not of the form key = value", "see the keys: " + keyNames());
        entry.key = trimmed(content.substr(0, equals));
        entry.value = trimmed(content.substr(equals + 1));
        if (!seen.emplace(entry.key).second && !repeats(entry.key))
            return entry.error("'" + std::string(entry.key) + "' stands here a second time",
                               "keep one of them");
        if (const auto assigned = assignEntry(file, entry); !assigned) return assigned.error();
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
