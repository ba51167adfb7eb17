// SPDX-License-Identifier: Apache-2.0
#include "RoamKeys.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>
#include <vector>

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Outcome;
using foundation::success;

Outcome assignOrigin(RoamFile& file, const RoamEntry& entry)
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

Outcome assignRoadsOrigin(RoamFile& file, const RoamEntry& entry)
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

Outcome assignSun(RoamFile& file, const RoamEntry& entry)
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
constexpr Word<WaterRule> kWaters[] = {
    {"level", WaterRule::level}, {"sea", WaterRule::sea}, {"none", WaterRule::none}};
constexpr Word<bool> kSurroundings[] = {{"made", true}, {"none", false}};
constexpr Word<VerticalDatum> kDatums[] = {{"automatic", VerticalDatum::automatic},
                                           {"egm96", VerticalDatum::egm96},
                                           {"ellipsoid", VerticalDatum::ellipsoid}};

Outcome assignVoids(RoamFile& file, const RoamEntry& entry)
{
    VoidsWord word{Voids::fill, false};
    const Outcome assigned = assignWord(word, entry, kVoids);
    file.import.voids = word.voids;
    file.showsVoids = word.shows;
    return assigned;
}

Outcome assignTriangles(RoamFile& file, const RoamEntry& entry)
{
    const auto number = numberWithin(entry, 2.0, 4.0e9);
    if (!number) return number.error();
    file.maxTriangles = static_cast<std::uint32_t>(*number);
    return success();
}

Outcome assignMethod(RoamFile& file, const RoamEntry& entry)
{
    const auto method = methodNamed(entry.value);
    if (!method) return unknownWord(entry, methodNames());
    file.method = *method;
    return success();
}

/// Resolves the path of a class table; the name of a built-in table stays as it is.
Outcome assignClasses(RoamFile& file, const RoamEntry& entry)
{
    if (entry.value != "worldcover" && entry.value != "corine")
        return assignPath(file.landCoverClasses, entry);
    file.landCoverClasses = std::string(entry.value);
    return success();
}

Outcome assignSeason(RoamFile& file, const RoamEntry& entry)
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

Outcome appendPath(std::vector<std::filesystem::path>& target, const RoamEntry& entry)
{
    return assignPath(target.emplace_back(), entry);
}

Outcome assignImagery(RoamFile& file, const RoamEntry& entry)
{
    if (file.imagery.size() < RoamFile::kMaxImagery) return appendPath(file.imagery, entry);
    return entry.error("is one imagery more than the " + std::to_string(RoamFile::kMaxImagery) +
                           " that there may be",
                       "join some with gdalbuildvrt");
}

Outcome assignClouds(RoamFile& file, const RoamEntry& entry)
{
    file.clouds = std::string(entry.value);
    return success();
}

Outcome assignGround(RoamFile& file, const RoamEntry& entry)
{
    file.ground = std::string(entry.value);
    return success();
}

/// A key, and the function that applies its value.
struct Key
{
    std::string_view name;
    Outcome (*assign)(RoamFile&, const RoamEntry&);
    bool repeats = false; ///< may appear in several lines
};

constexpr double kFar = 1.0e7; ///< metres; larger than the Earth's radius

constexpr std::array kKeys{
    Key{"dem", [](RoamFile& f, const RoamEntry& e) { return appendPath(f.dems, e); }, true},
    Key{"voids", assignVoids},
    Key{"imagery", assignImagery, true},
    Key{"features", [](RoamFile& f, const RoamEntry& e) { return appendPath(f.features, e); }, true},
    Key{"buildings", [](RoamFile& f, const RoamEntry& e) { return appendPath(f.buildings, e); }, true},
    Key{"objects", [](RoamFile& f, const RoamEntry& e) { return appendPath(f.objects, e); }, true},
    Key{"structures", [](RoamFile& f, const RoamEntry& e) { return appendPath(f.structures, e); }, true},
    Key{"earthworks", [](RoamFile& f, const RoamEntry& e) { return appendPath(f.earthworks, e); }, true},
    Key{"land_cover", [](RoamFile& f, const RoamEntry& e) { return assignPath(f.landCover, e); }},
    Key{"land_cover_classes", assignClasses},
    Key{"season", assignSeason},
    Key{"roads", [](RoamFile& f, const RoamEntry& e) { return assignPath(f.roads, e); }},
    Key{"edits", [](RoamFile& f, const RoamEntry& e) { return assignPath(f.edits, e); }},
    Key{"roads_origin", assignRoadsOrigin},
    Key{"roads_heights",
        [](RoamFile& f, const RoamEntry& e) { return assignWord(f.roadsOnGround, e, kRoadsHeights); }},
    Key{"origin", assignOrigin},
    Key{"placement", [](RoamFile& f, const RoamEntry& e) { return assignWord(f.placement, e, kPlacements); }},
    Key{"spacing",
        [](RoamFile& f, const RoamEntry& e) { return assignNumber(f.import.spacingM, e, 1e-3, kFar); }},
    Key{"vertical_datum",
        [](RoamFile& f, const RoamEntry& e) { return assignWord(f.import.verticalDatum, e, kDatums); }},
    Key{"finest_spacing",
        [](RoamFile& f, const RoamEntry& e) { return assignNumber(f.finestSpacingM, e, 0.01, 1000.0); }},
    Key{"method", assignMethod},
    Key{"error_tolerance",
        [](RoamFile& f, const RoamEntry& e) { return assignNumber(f.errorTolerancePx, e, 1e-3, 1e3); }},
    Key{"max_triangles", assignTriangles},
    Key{"view_margin",
        [](RoamFile& f, const RoamEntry& e) { return assignNumber(f.viewMarginDeg, e, 0.0, 90.0); }},
    Key{"adapt_time_us",
        [](RoamFile& f, const RoamEntry& e) { return assignNumber(f.adaptTimeUs, e, 1.0, 1e6); }},
    Key{"aridity", [](RoamFile& f, const RoamEntry& e) { return assignNumber(f.land.aridity, e, 0.0, 1.0); }},
    Key{"tree_line",
        [](RoamFile& f, const RoamEntry& e) { return assignNumber(f.land.treeLineM, e, -kFar, kFar); }},
    Key{"snow_line",
        [](RoamFile& f, const RoamEntry& e) { return assignNumber(f.land.snowLineM, e, -kFar, kFar); }},
    Key{"sea_level",
        [](RoamFile& f, const RoamEntry& e) { return assignNumber(f.land.seaLevelM, e, -kFar, kFar); }},
    Key{"water", [](RoamFile& f, const RoamEntry& e) { return assignWord(f.land.water, e, kWaters); }},
    Key{"sun", assignSun},
    Key{"surroundings",
        [](RoamFile& f, const RoamEntry& e) { return assignWord(f.surroundings, e, kSurroundings); }},
    Key{"moonlight", [](RoamFile& f, const RoamEntry& e) { return assignNumber(f.moonlight, e, 0.0, 1.0); }},
    Key{"clouds", assignClouds},
    Key{"ground", assignGround},
    Key{"visibility",
        [](RoamFile& f, const RoamEntry& e) { return assignNumber(f.visibilityM, e, 1.0, kFar); }},
};

} // namespace

std::string roamKeyNames()
{
    std::string names;
    for (const Key& key : kKeys)
        names += (names.empty() ? "" : ", ") + std::string(key.name);
    return names;
}

foundation::Outcome assignRoamEntry(RoamFile& file, const RoamEntry& entry)
{
    if (entry.value.empty())
        return entry.error(std::string(entry.key) + " has no value",
                           "write key = value, or take the line out");
    for (const Key& key : kKeys)
        if (key.name == entry.key) return key.assign(file, entry);
    return entry.error("unknown key '" + std::string(entry.key) + "'", "known keys: " + roamKeyNames());
}

bool repeatsInRoamFile(std::string_view name)
{
    return std::any_of(kKeys.begin(), kKeys.end(),
                       [=](const Key& key) { return key.name == name && key.repeats; });
}

} // namespace osgTerrainROAM::core
