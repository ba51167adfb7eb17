// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>
#include <string_view>

#include <osgTerrainROAM/core/features/FeatureImport.h>
#include <osgTerrainROAM/core/features/ShapeImport.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

#include "scenery/buildings/StandBuildings.h"
#include "scenery/ground/TileGround.h"
#include "scenery/roads/LayRoads.h"
#include "scenery/roads/NearestStreet.h"
#include "scenery/structures/HeightsInScene.h"
#include "worldmaking/check/WorldCheck.h"
#include "worldmaking/plan/PlanGrid.h"
#include "worldtool/Commands.h"
#include "worldtool/FaultLines.h"

namespace worldtool
{

namespace
{

using osgTerrainROAM::core::FeatureKind;
using osgTerrainROAM::core::PlacedTile;
using osgTerrainROAM::core::RoamFile;
using worldmaking::WorldThings;

foundation::Outcome addHouses(const RoamFile& world, const PlacedTile& tile, WorldThings& things)
{
    for (const auto& source : world.buildings)
    {
        const auto shapes = osgTerrainROAM::core::importShapes(source, tile);
        if (!shapes) return shapes.error();
        auto made = scenery::standBuildings(*shapes, things.groundM,
                                            things.roads ? scenery::nearestStreet(*things.roads)
                                                         : scenery::NearestStreet());
        for (auto& house : made.buildings)
            things.houses.push_back(std::move(house));
    }
    return foundation::success();
}

foundation::Outcome addPlants(const RoamFile& world, const PlacedTile& tile, WorldThings& things)
{
    for (const auto& source : world.objects)
    {
        const auto shapes = osgTerrainROAM::core::importShapes(source, tile);
        if (!shapes) return shapes.error();
        for (const auto& shape : shapes->shapes)
            if (!shape.isArea()) things.plants.push_back(shape.point);
    }
    return foundation::success();
}

/// The paving of a runway: its line, as wide as it is.
worldmaking::PlanRings pavingOf(const std::vector<glm::dvec2>& line, double widthM)
{
    const glm::dvec2 along = glm::normalize(line.back() - line.front());
    const glm::dvec2 side = 0.5 * widthM * glm::dvec2(-along.y, along.x);
    return {{line.front() - side, line.back() - side, line.back() + side, line.front() + side}};
}

foundation::Outcome addRails(const RoamFile& world, const PlacedTile& tile, WorldThings& things)
{
    for (const auto& source : world.structures)
    {
        const auto shapes = osgTerrainROAM::core::importShapes(source, tile);
        if (!shapes) return shapes.error();
        for (const auto& line : shapes->linear)
        {
            auto structure =
                scenery::structureOf(line.points, line.tags, static_cast<std::uint64_t>(line.id));
            if (!structure || structure->heightsM.empty()) continue; // on the ground, whatever that is
            scenery::putHeightsInScene(*structure, tile);
            worldmaking::RailLine rail;
            if (structure->kind == scenery::StructureKind::footRamp) continue;
            rail.isFootbridge = structure->kind == scenery::StructureKind::footbridge;
            rail.isTube = structure->isTunnel;
            for (std::size_t i = 0; i < structure->heightsM.size(); ++i)
                rail.points.emplace_back(structure->line[i], structure->heightsM[i]);
            things.rails.push_back(std::move(rail));
        }
    }
    return foundation::success();
}

foundation::Outcome addGround(const RoamFile& world, const PlacedTile& tile, WorldThings& things)
{
    for (const auto& source : world.features)
    {
        const auto set = osgTerrainROAM::core::importFeatures(source, tile);
        if (!set) return set.error();
        for (const auto& feature : set->features)
        {
            if (feature.style.kind == FeatureKind::river && feature.isArea)
                things.waters.push_back(feature.paths);
            if (feature.style.kind == FeatureKind::river && !feature.isArea)
                things.courses.insert(things.courses.end(), feature.paths.begin(), feature.paths.end());
            if (feature.style.kind == FeatureKind::runway && !feature.isArea)
                things.runways.push_back(pavingOf(feature.paths.front(), feature.style.widthM));
        }
    }
    return foundation::success();
}

nlohmann::ordered_json rowOf(const worldmaking::WorldFaults& faults)
{
    return {{"objects", faults.objects},
            {"roadsKm", faults.roadsKm},
            {"onRoad", faults.onRoad},
            {"inWater", faults.inWater},
            {"onRunway", faults.onRunway},
            {"overlapping", faults.overlapping},
            {"floating", faults.floating},
            {"floatingRoads", faults.floatingRoads},
            {"sunkRoads", faults.sunkRoads},
            {"unevenRunways", faults.unevenRunways},
            {"unevenWaters", faults.unevenWaters},
            {"closeCrossings", faults.closeCrossings},
            {"bareTunnels", faults.bareTunnels},
            {"brokenRails", faults.brokenRails},
            {"steppedJunctions", faults.steppedJunctions},
            {"steepJunctions", faults.steepJunctions},
            {"maxGradePercent", faults.maxGradePercent}};
}

} // namespace

namespace
{

/// Adds where a place of a tile that lies on the Earth is. Units: degrees.
void addDegrees(nlohmann::ordered_json& row, const glm::dvec3& place, const PlacedTile& tile)
{
    if (tile.frame().placement() != osgTerrainROAM::core::Placement::curved) return;
    const auto at = tile.frame().geodeticFromLocal(place);
    row["latitudeDeg"] = at.latitudeDeg;
    row["longitudeDeg"] = at.longitudeDeg;
}

/// The places of roads that the ground leaves or covers. Units: metres, degrees.
nlohmann::ordered_json placesOf(const worldmaking::WorldFaults& faults,
                                const osgRoads::core::PlacedNetwork& roads, const PlacedTile& tile)
{
    auto rows = nlohmann::ordered_json::array();
    for (const auto& fault : faults.roadFaults)
    {
        const auto& road = roads.road(fault.road);
        nlohmann::ordered_json row{{"fault", fault.isSunk ? "sunk" : "floating"},
                                   {"road", road.id},
                                   {"sM", fault.sM},
                                   {"byM", fault.byM},
                                   {"isTurn", !road.junctionId.empty()}};
        addDegrees(row, fault.place, tile);
        if (fault.other >= 0)
            row["beside"] = {{"road", roads.road(fault.other).id},
                             {"awayM", fault.otherM},
                             {"higherM", fault.otherHigherM}};
        rows.push_back(std::move(row));
    }
    return rows;
}

/// The houses that do not stand on their ground. Units: metres, degrees.
nlohmann::ordered_json housesOf(const worldmaking::WorldFaults& faults, const PlacedTile& tile)
{
    using Flaw = worldmaking::HouseFault::Flaw;
    auto rows = nlohmann::ordered_json::array();
    for (const auto& fault : faults.houseFaults)
    {
        nlohmann::ordered_json row{{"fault", fault.flaw == Flaw::floats ? "floats"
                                             : fault.flaw == Flaw::sunk ? "sunk"
                                                                        : "beyond"},
                                   {"byM", fault.byM}};
        addDegrees(row, fault.place, tile);
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Gives faults of waters the names that the map has.
void nameWaters(const RoamFile& world, const PlacedTile& tile, worldmaking::WorldFaults& faults)
{
    if (faults.waterFaults.empty()) return;
    for (const auto& source : world.features)
    {
        const auto shapes = osgTerrainROAM::core::importShapes(source, tile);
        if (!shapes) return; // they have been read once
        for (const auto& shape : shapes->shapes)
        {
            const auto name = shape.tags.find("name");
            if (!shape.isArea() || name == shape.tags.end() || name->second.empty()) continue;
            const auto box = worldmaking::boxOf(shape.rings.front());
            for (auto& fault : faults.waterFaults)
                if (glm::distance(fault.place, 0.5 * (box.low + box.high)) < 0.5) fault.name = name->second;
        }
    }
}

/// The waters that do not lie as water does. Units: metres, degrees.
nlohmann::ordered_json watersOf(const worldmaking::WorldFaults& faults, const PlacedTile& tile)
{
    auto rows = nlohmann::ordered_json::array();
    for (const auto& fault : faults.waterFaults)
    {
        nlohmann::ordered_json row{{"name", fault.name},
                                   {"areaM2", fault.areaM2},
                                   {"slope", fault.figures.slope},
                                   {"fall", fault.figures.fall},
                                   {"rise", fault.figures.rise},
                                   {"lowShore", fault.figures.lowShore},
                                   {"isKnown", fault.figures.isKnown}};
        addDegrees(row, {fault.place, 0.0}, tile);
        nlohmann::ordered_json steepest;
        if (fault.figures.slope > 0.0) addDegrees(steepest, {fault.figures.steepAt, 0.0}, tile);
        if (!steepest.is_null()) row["steepestAt"] = std::move(steepest);
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Where ways cross wrongly. Units: metres, degrees.
nlohmann::ordered_json crossingsOf(const worldmaking::WorldFaults& faults,
                                   const osgRoads::core::PlacedNetwork* roads, const PlacedTile& tile)
{
    auto rows = nlohmann::ordered_json::array();
    for (const auto& fault : faults.crossingFaults)
    {
        nlohmann::ordered_json row{{"fault", worldmaking::wordOf(fault.flaw)},
                                   {"sM", fault.sM},
                                   {"foundM", fault.foundM},
                                   {"wantedM", fault.wantedM}};
        if (roads && fault.road >= 0) row["road"] = roads->road(fault.road).id;
        if (roads && fault.other >= 0) row["other"] = roads->road(fault.other).id;
        addDegrees(row, fault.place, tile);
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Where the surface of crossings is wrong. Units: metres, degrees.
nlohmann::ordered_json junctionsOf(const worldmaking::WorldFaults& faults,
                                   const osgRoads::core::PlacedNetwork& roads, const PlacedTile& tile)
{
    auto rows = nlohmann::ordered_json::array();
    for (const auto& fault : faults.junctionFaults)
    {
        const auto& road = roads.road(fault.road);
        const bool isStep = fault.flaw == worldmaking::JunctionFlaw::step;
        nlohmann::ordered_json row{{"fault", isStep ? "step" : "steep"},
                                   {"junction", road.junctionId},
                                   {"road", road.id},
                                   {"sM", fault.sM},
                                   {isStep ? "byM" : "lean", fault.by}};
        if (fault.other >= 0) row["other"] = roads.road(fault.other).id;
        addDegrees(row, fault.place, tile);
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace

foundation::Result<Report> check(const std::filesystem::path& world)
{
    const auto file = std::filesystem::is_directory(world) ? world / "world.roam" : world;
    const auto description = osgTerrainROAM::core::readRoamFile(file);
    if (!description) return description.error();
    const auto loaded = scenery::loadRoadTile(*description);
    if (!loaded) return loaded.error();
    const PlacedTile& tile = loaded->tile->tile;
    WorldThings things;
    things.roads = loaded->roads.placed.get();
    things.groundM = ground::groundOf(tile).heights();
    things.elevationM = [&](const glm::dvec2& place) -> std::optional<double>
    {
        const auto ground = osgTerrainROAM::core::groundAt(tile, place.x, place.y);
        return ground ? std::optional(tile.frame().heightOf(ground->position)) : std::nullopt;
    };
    for (const auto add : {addHouses, addPlants, addRails, addGround})
        if (const auto added = add(*description, tile, things); !added) return added.error();
    worldmaking::WorldFaults faults = worldmaking::checkWorld(things);
    nameWaters(*description, tile, faults);
    Report report;
    report.json = rowOf(faults);
    report.sound = faults.total() == 0;
    for (const auto& [key, value] : report.json.items())
        std::cout << key << ' ' << value.dump() << '\n';
    for (const std::string& line : faultLines(faults, things.roads, tile))
        std::cout << "fault: " << line << '\n';
    if (things.roads) report.json["roadFaults"] = placesOf(faults, *things.roads, tile);
    if (things.roads) report.json["junctionFaults"] = junctionsOf(faults, *things.roads, tile);
    report.json["houseFaults"] = housesOf(faults, tile);
    report.json["waterFaults"] = watersOf(faults, tile);
    report.json["crossingFaults"] = crossingsOf(faults, things.roads, tile);
    return report;
}

} // namespace worldtool
