// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/LandUse.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include "scenery/buildings/BuildingRules.h"
#include "scenery/buildings/Outline.h"
#include "scenery/structures/Structure.h"
#include "worldmaking/land/MapFile.h"
#include "worldmaking/map/WaterTags.h"
#include "worldmaking/plan/Waters.h"
#include "worldmaking/streets/PathTags.h"
#include "worldmaking/streets/StreetTraits.h"
#include "worldmaking/streets/WaitTags.h"

namespace worldmaking
{

namespace
{

constexpr double kTexelM = 10.0;
constexpr std::size_t kMostUnused = 60; ///< counted by name

struct CoverWord
{
    std::string_view key, value;
    Cover cover;
};

constexpr std::array<CoverWord, 41> kCovers{{{"landuse", "forest", Cover::trees},
                                             {"natural", "wood", Cover::trees},
                                             {"natural", "scrub", Cover::shrubs},
                                             {"natural", "heath", Cover::shrubs},
                                             {"natural", "grassland", Cover::grass},
                                             {"natural", "fell", Cover::grass},
                                             {"landuse", "meadow", Cover::grass},
                                             {"landuse", "grass", Cover::grass},
                                             {"landuse", "village_green", Cover::grass},
                                             {"landuse", "recreation_ground", Cover::grass},
                                             {"landuse", "cemetery", Cover::grass},
                                             {"landuse", "allotments", Cover::garden},
                                             {"landuse", "residential", Cover::garden},
                                             {"landuse", "farmyard", Cover::yard},
                                             {"landuse", "orchard", Cover::grass},
                                             {"landuse", "greenfield", Cover::grass},
                                             {"leisure", "park", Cover::grass},
                                             {"leisure", "garden", Cover::garden},
                                             {"leisure", "pitch", Cover::grass},
                                             {"leisure", "golf_course", Cover::grass},
                                             {"leisure", "playground", Cover::grass},
                                             {"landuse", "farmland", Cover::crops},
                                             {"landuse", "vineyard", Cover::crops},
                                             {"landuse", "industrial", Cover::yard},
                                             {"landuse", "commercial", Cover::yard},
                                             {"landuse", "retail", Cover::yard},
                                             {"landuse", "railway", Cover::yard},
                                             {"landuse", "garages", Cover::yard},
                                             {"amenity", "parking", Cover::yard},
                                             {"place", "square", Cover::yard},
                                             {"highway", "pedestrian", Cover::yard},
                                             {"natural", "bare_rock", Cover::bare},
                                             {"natural", "scree", Cover::bare},
                                             {"natural", "shingle", Cover::bare},
                                             {"natural", "sand", Cover::bare},
                                             {"landuse", "quarry", Cover::bare},
                                             {"landuse", "construction", Cover::bare},
                                             {"natural", "glacier", Cover::ice},
                                             {"natural", "wetland", Cover::wetland},
                                             {"natural", "beach", Cover::bare},
                                             {"natural", "rock", Cover::bare}}};

constexpr std::array<std::string_view, 5> kFields{"farmland", "meadow", "grass", "orchard", "vineyard"};
constexpr std::array<std::string_view, 5> kRivers{"river", "stream", "canal", "ditch", "drain"};
constexpr std::array<std::string_view, 3> kTaxiways{"taxiway", "taxilane", "parking_position"};
constexpr std::array<std::string_view, 4> kRails{"rail", "narrow_gauge", "light_rail", "tram"};

template<std::size_t N>
bool isOneOf(std::string_view value, const std::array<std::string_view, N>& words)
{
    return std::find(words.begin(), words.end(), value) != words.end();
}

bool isSet(const Tags& tags, std::string_view key)
{
    const auto value = valueOf(tags, key);
    return !value.empty() && value != "no";
}

/// Where a thing goes, and as what.
enum class GroundLayer : std::uint8_t
{
    fields,
    waters,
    rivers,
    ways,
    aprons,
};

struct Painted
{
    GroundLayer layer;
    Tags tags; ///< kind, and what else its look follows from
};

Tags withDetails(std::string_view kind, const Tags& tags, std::initializer_list<const char*> keys)
{
    Tags made{{"kind", std::string(kind)}};
    for (const char* key : keys)
        if (const auto value = valueOf(tags, key); !value.empty()) made.emplace(key, value);
    return made;
}

std::optional<Painted> paintedLine(const LandShape& shape, LandReport& report)
{
    const Tags& tags = shape.tags;
    if (isSet(tags, "tunnel") || valueOf(tags, "location") == "underground") return std::nullopt;
    if (const auto way = valueOf(tags, "waterway"); isOneOf(way, kRivers))
    {
        ++report.waterLines;
        Tags made = withDetails(way, tags, {"width"});
        if (const auto widthM = riverWidthM(shape)) made["width"] = std::to_string(*widthM);
        return Painted{GroundLayer::rivers, std::move(made)};
    }
    if (isFootway(tags) && !isSet(tags, "bridge"))
    {
        ++report.ways;
        const auto path = valueOf(tags, "highway");
        return Painted{GroundLayer::ways,
                       withDetails(path == "steps" ? "footway" : path, tags, {"width", "surface"})};
    }
    if (const auto rail = valueOf(tags, "railway"); isOneOf(rail, kRails) && !isSet(tags, "bridge"))
    {
        ++report.railways;
        return Painted{GroundLayer::ways, {{"kind", "track"}, {"width", "4"}, {"surface", "gravel"}}};
    }
    if (const auto air = valueOf(tags, "aeroway"); isOneOf(air, kTaxiways))
    {
        ++report.aprons;
        return Painted{GroundLayer::ways, withDetails(air, tags, {"width", "surface"})};
    }
    return std::nullopt;
}

std::optional<Painted> paintedArea(const LandShape& shape, LandReport& report)
{
    if (isWater(shape))
    {
        ++report.waters;
        return Painted{GroundLayer::waters, withDetails("water", shape.tags, {"name"})};
    }
    if (const auto use = valueOf(shape.tags, "landuse"); isOneOf(use, kFields))
    {
        ++report.fields;
        return Painted{GroundLayer::fields, withDetails(use, shape.tags, {"crop"})};
    }
    if (valueOf(shape.tags, "aeroway") == "apron")
    {
        ++report.aprons;
        return Painted{GroundLayer::aprons, {{"kind", "apron"}}};
    }
    return std::nullopt;
}

/// Counts a thing that nothing is made of, by the tag that names it.
void countUnused(const LandShape& shape, LandReport& report)
{
    const Tags& tags = shape.tags;
    if (isSet(tags, "building") || coverOf(tags) || (isSet(tags, "highway") && traitsOf(tags))) return;
    const auto natural = valueOf(tags, "natural");
    if (valueOf(tags, "aeroway") == "runway" || valueOf(tags, "aeroway") == "windsock") return;
    if (valueOf(tags, "highway") == "street_lamp") return;
    if (shape.form == ShapeForm::point && !waitTagsOf(tags).isEmpty()) return;         // of streets
    if (valueOf(tags, "power") == "tower" || valueOf(tags, "power") == "pole") return; // where lines bend
    if (scenery::structureOf(std::vector<glm::dvec2>(shape.form == ShapeForm::point ? 1 : 2), tags, 0))
        return;
    if (natural == "tree" || natural == "tree_row" || valueOf(tags, "barrier") == "hedge") return; // planted
    if (shape.form == ShapeForm::point && scenery::towerOf(glm::dvec2(0.0), tags, 0)) return;
    for (const char* key : {"aeroway", "highway", "waterway", "railway", "aerialway", "power", "barrier",
                            "landuse", "natural", "leisure", "man_made"})
        if (const auto value = valueOf(tags, key); !value.empty())
        {
            const std::string name = std::string(key) + "=" + std::string(value);
            const bool isKnown = report.unused.size() < kMostUnused || report.unused.contains(name);
            ++report.unused[isKnown ? name : "(others)"];
            return;
        }
}

Tags tagsOf(const Runway& runway)
{
    return {{"kind", "runway"},
            {"width", std::to_string(runway.widthM)},
            {"surface", runway.surface},
            {"ref", runway.designators}};
}

} // namespace

std::optional<Cover> coverOf(const Tags& tags)
{
    for (const CoverWord& word : kCovers)
        if (valueOf(tags, word.key) == word.value) return word.cover;
    return std::nullopt;
}

std::optional<MapBox> extentOf(const LandMap& map, const MapPlane& plane)
{
    MapBox box{glm::dvec2(1e300), glm::dvec2(-1e300)};
    for (const LandShape& shape : map.shapes)
    {
        const auto paths = plane.toPlan(shape.paths);
        if (!paths || paths->empty()) continue;
        const MapBox its = boxOf(paths->front());
        box = {glm::min(box.low, its.low), glm::max(box.high, its.high)};
    }
    return box.low.x <= box.high.x ? std::optional(box) : std::nullopt;
}

CoverRaster coverRasterOf(const LandMap& map, const MapPlane& plane, const std::optional<MapBox>& limit,
                          LandReport& report)
{
    struct Area
    {
        PlanRings rings;
        Cover cover;
        double areaM2;
    };
    std::vector<Area> areas;
    MapBox box{glm::dvec2(1e300), glm::dvec2(-1e300)};
    for (const LandShape& shape : map.shapes)
    {
        const auto cover = isWater(shape) ? std::optional(Cover::water) : coverOf(shape.tags);
        auto rings = cover && shape.form == ShapeForm::area ? plane.toPlan(shape.paths) : std::nullopt;
        if (!rings) continue;
        const MapBox its = boxOf(rings->front());
        box = {glm::min(box.low, its.low), glm::max(box.high, its.high)};
        const double areaM2 = *cover == Cover::water ? 0.0 : scenery::areaOf(*rings);
        areas.push_back({std::move(*rings), *cover, areaM2});
    }
    report.coverAreas = areas.size();
    if (areas.empty()) box = {};
    if (limit) box = *limit;
    std::stable_sort(areas.begin(), areas.end(),
                     [](const Area& a, const Area& b) { return a.areaM2 > b.areaM2; });
    CoverRaster raster(box, kTexelM);
    for (const Area& area : areas)
        raster.paint(area.rings, area.cover);
    return raster;
}

foundation::Outcome writeGround(const LandMap& map, std::span<const Runway> runways,
                                const std::filesystem::path& file, LandReport& report)
{
    std::array<std::vector<std::pair<const LandShape*, Tags>>, 5> layers;
    for (const LandShape& shape : map.shapes)
    {
        std::optional<Painted> painted;
        if (shape.form == ShapeForm::line) painted = paintedLine(shape, report);
        if (shape.form == ShapeForm::area) painted = paintedArea(shape, report);
        if (painted)
            layers[static_cast<std::size_t>(painted->layer)].emplace_back(&shape, std::move(painted->tags));
        else
            countUnused(shape, report);
    }
    MapFile made(file);
    const std::array<std::pair<const char*, ShapeForm>, 5> names{{{"fields", ShapeForm::area},
                                                                  {"waters", ShapeForm::area},
                                                                  {"rivers", ShapeForm::line},
                                                                  {"ways", ShapeForm::line},
                                                                  {"aprons", ShapeForm::area}}};
    for (std::size_t i = 0; i < names.size(); ++i)
    {
        if (layers[i].empty()) continue;
        std::vector<std::string> keys{"kind", "width", "surface", "crop"};
        const bool hasName = std::any_of(layers[i].begin(), layers[i].end(),
                                         [](const auto& painted) { return painted.second.contains("name"); });
        if (hasName) keys.emplace_back("name"); // of waters: what is wrong with one names it
        made.beginLayer(names[i].first, names[i].second, keys);
        for (const auto& [shape, tags] : layers[i])
            made.add(shape->paths, tags);
    }
    if (!runways.empty()) made.beginLayer("runways", ShapeForm::line, {"kind", "width", "surface", "ref"});
    for (const Runway& runway : runways)
        made.add({{runway.from, runway.to}}, tagsOf(runway));
    report.runways = runways.size();
    return made.finish();
}

} // namespace worldmaking
