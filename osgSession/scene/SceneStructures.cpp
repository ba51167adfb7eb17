// SPDX-License-Identifier: Apache-2.0
#include "SceneStructures.h"

#include <cmath>
#include <string>
#include <utility>

#include <foundation/Angle.h>

#include <osg/Notify>

#include <osgTerrainROAM/core/features/OpeningCells.h>

#include "ReadShapes.h"
#include "scenery/ground/TileGround.h"
#include "scenery/lights/RunwayLights.h"
#include "scenery/nodes/RoadThingsNode.h"
#include "scenery/nodes/StructuresNode.h"
#include "scenery/roads/TunnelOpenings.h"
#include "scenery/structures/HeightsInScene.h"
#include "scenery/structures/HoldingSigns.h"
#include "scenery/structures/RailTube.h"
#include "scenery/structures/StructureObstacles.h"

namespace trainer
{

namespace
{

template<class Tags>
bool isKind(const Tags& tags, const char* key, const char* value)
{
    const auto found = tags.find(key);
    return found != tags.end() && found->second == value;
}

bool isWindsock(const osgTerrainROAM::core::MapShape& shape)
{
    return isKind(shape.tags, "kind", "windsock") || isKind(shape.tags, "aeroway", "windsock");
}

void add(const osgTerrainROAM::core::ShapeSet& shapes, const osgTerrainROAM::core::PlacedTile& tile,
         MadeStructures& standing)
{
    const auto take = [&](std::vector<glm::dvec2> line, const scenery::StructureTags& tags, std::int64_t id)
    {
        auto structure = scenery::structureOf(std::move(line), tags, static_cast<std::uint64_t>(id));
        if (structure)
        {
            scenery::putHeightsInScene(*structure, tile);
            standing.structures.push_back(std::move(*structure));
        }
        else
            ++standing.unused;
    };
    for (const auto& line : shapes.linear)
        if (isKind(line.tags, "kind", "street"))
            (isKind(line.tags, "lit", "yes") ? standing.lamps.lit : standing.lamps.unlit)
                .push_back(line.points);
        else
            take(line.points, line.tags, line.id);
    for (const auto& shape : shapes.shapes)
        if (!shape.isArea() && isWindsock(shape))
            standing.windsocks.push_back(shape.point);
        else if (!shape.isArea() && isKind(shape.tags, "kind", "street_lamp"))
            standing.lamps.posts.push_back(shape.point);
        else if (!shape.isArea())
            take({shape.point}, shape.tags, shape.id);
        else
            ++standing.unused;
}

glm::dvec2 directionOf(const StripRequest& strip)
{
    const double course = foundation::radiansOf(strip.courseDeg);
    return {std::sin(course), std::cos(course)};
}

scenery::RunwayPlan planOf(const SceneRunway& runway)
{
    const StripRequest& strip = runway.strip;
    return {strip.threshold, strip.threshold + strip.lengthM * directionOf(strip), strip.widthM,
            runway.isPaved};
}

/// The lamps of runways and taxiways. A taxiway without a lit runway has none.
std::vector<scenery::LightPoint> lampsOf(const SceneAirfields& airfields,
                                         const foundation::HeightInPlan& ground)
{
    std::vector<scenery::RunwayPlan> plans;
    std::vector<scenery::LightPoint> lamps;
    const auto take = [&](const std::vector<scenery::LightPoint>& some)
    { lamps.insert(lamps.end(), some.begin(), some.end()); };
    for (const SceneRunway& runway : airfields.runways)
    {
        plans.push_back(planOf(runway));
        take(scenery::runwayLights(plans.back(), ground));
    }
    if (lamps.empty()) return lamps;
    for (const SceneTaxiway& way : airfields.taxiways)
        take(scenery::taxiwayLights(way.middle, way.widthM, plans, ground));
    return lamps;
}

/// The PAPI of both ends of a runway.
void addPapis(const SceneRunway& runway, const foundation::HeightInPlan& ground,
              std::vector<scenery::PapiUnit>& papis)
{
    const StripRequest& strip = runway.strip;
    if (!runway.isPaved || strip.lengthM < kLeastPapiM) return;
    const glm::dvec2 along = directionOf(strip);
    for (const double way : {1.0, -1.0})
    {
        const glm::dvec2 threshold = strip.threshold + (way > 0.0 ? 0.0 : strip.lengthM) * along;
        for (scenery::PapiUnit unit : scenery::papiUnits(threshold, way * along, strip.lengthM, strip.widthM))
        {
            unit.place.z = ground(glm::dvec2(unit.place)).value_or(0.0);
            papis.push_back(unit);
        }
    }
}

foundation::HeightInPlan groundOf(const osgTerrainROAM::core::PlacedTile& tile)
{
    return ground::groundOf(tile).heights();
}

/// Cuts the ground open where railways and roads enter tunnels.
foundation::Outcome openTunnels(const std::vector<scenery::Structure>& structures, SceneTerrain& scene)
{
    auto openings = scenery::railOpenings(structures);
    if (openings.empty()) return foundation::success();
    if (scene.roads)
        for (auto& opening : scenery::tunnelOpenings(*scene.roads))
            openings.push_back(std::move(opening));
    const auto cells = osgTerrainROAM::core::OpeningCells::build(openings);
    if (!cells) return cells.error();
    scene.terrain->material()->setOpenings(*cells);
    return foundation::success();
}

} // namespace

foundation::Result<MadeStructures> makeStructures(const osgTerrainROAM::core::RoamFile& description,
                                                  const osgTerrainROAM::core::RoamTile& tile,
                                                  bool wantsObstacles)
{
    MadeStructures made;
    for (const auto& source : description.structures)
    {
        const auto shapes = readShapes(source, tile);
        if (!shapes) return shapes.error();
        made.notes.insert(made.notes.end(), shapes->notes.begin(), shapes->notes.end());
        add(*shapes, tile.tile, made);
        const bool hasLamps = made.lamps.posts.size() + made.lamps.lit.size() + made.lamps.unlit.size() > 0;
        if (made.structures.empty() && made.windsocks.empty() && !hasLamps)
            return foundation::Error{source.string(), "has nothing that can stand here",
                                     "give lines of walls, fences, power lines or railways of this place"};
    }
    if (wantsObstacles) scenery::addObstacles(made.structures, groundOf(tile.tile), made.obstacles);
    if (!made.structures.empty())
        made.node = scenery::makeStructuresNode(
            scenery::structureFacets(made.structures, groundOf(tile.tile), made.beyondGround));
    return made;
}

scenery::roads::RoadThings airfieldSigns(const SceneAirfields& airfields,
                                         const osgTerrainROAM::core::PlacedTile& tile)
{
    std::vector<scenery::PavedWay> paved;
    for (const SceneTaxiway& way : airfields.taxiways)
        paved.push_back({way.middle, way.widthM});
    for (const SceneRunway& runway : airfields.runways)
    {
        const scenery::RunwayPlan plan = planOf(runway);
        paved.push_back({{plan.from, plan.to}, plan.widthM});
    }
    return scenery::holdingSigns(airfields.holds, paved, groundOf(tile));
}

foundation::Outcome addStructures(const MadeStructures& made, const SceneAirfields& airfields,
                                  const scenery::roads::RoadThings& signs, SceneTerrain& scene)
{
    scene.runways = airfields.runways;
    for (const std::string& note : made.notes)
        OSG_NOTICE << note << '\n';
    const foundation::HeightInPlan ground = groundOf(scene.terrain->tile()->tile);
    std::vector<scenery::PapiUnit> papis;
    for (const SceneRunway& runway : scene.runways)
        addPapis(runway, ground, papis);
    const auto lamps = lampsOf(airfields, ground);
    std::vector<glm::dvec3> socks;
    for (const glm::dvec2& place : made.windsocks)
        if (const auto height = ground(place)) socks.emplace_back(place, *height);
    if (!made.node && papis.empty() && lamps.empty() && socks.empty() && signs.standing.empty())
        return foundation::success();
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(scene.node);
    if (made.node)
    {
        if (const auto opened = openTunnels(made.structures, scene); !opened) return opened;
        scene.standing.push_back({"structures", made.node});
        group->addChild(made.node);
    }
    if (!signs.standing.empty())
    {
        const auto node = scenery::RoadThingsNode::create(signs);
        if (!node) return node.error();
        scene.standing.push_back({"signs", (*node)->node()});
        group->addChild((*node)->node());
    }
    if (made.unused + made.beyondGround > 0)
        OSG_NOTICE << "structures: " << made.unused << " of no known kind, " << made.beyondGround
                   << " beyond the ground\n";
    scene.airfield = std::make_shared<scenery::AirfieldNode>(papis, socks, lamps);
    group->addChild(scene.airfield->node());
    scene.node = group;
    return foundation::success();
}

} // namespace trainer
