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
#include "scenery/nodes/StructuresNode.h"
#include "scenery/roads/TunnelOpenings.h"
#include "scenery/structures/HeightsInScene.h"
#include "scenery/structures/RailTube.h"

namespace trainer
{

namespace
{

/// What a world has besides its ground.
struct Standing
{
    std::vector<scenery::Structure> structures;
    std::vector<glm::dvec2> windsocks;
    std::size_t unused = 0;
};

bool isWindsock(const osgTerrainROAM::core::MapShape& shape)
{
    for (const char* key : {"kind", "aeroway"})
        if (const auto found = shape.tags.find(key); found != shape.tags.end() && found->second == "windsock")
            return true;
    return false;
}

void add(const osgTerrainROAM::core::ShapeSet& shapes, const osgTerrainROAM::core::PlacedTile& tile,
         Standing& standing)
{
    const auto take = [&](std::vector<glm::dvec2> line, const auto& tags, std::int64_t id)
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
        take(line.points, line.tags, line.id);
    for (const auto& shape : shapes.shapes)
        if (!shape.isArea() && isWindsock(shape))
            standing.windsocks.push_back(shape.point);
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

/// The approach lights of both ends of a runway.
void addPapis(const SceneRunway& runway, const scenery::GroundHeight& ground,
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
            unit.place.z = ground(unit.place.x, unit.place.y).value_or(0.0);
            papis.push_back(unit);
        }
    }
}

foundation::Result<Standing> standingOf(const osgTerrainROAM::core::RoamFile& description,
                                        const osgTerrainROAM::core::RoamTile& tile)
{
    Standing standing;
    for (const auto& source : description.structures)
    {
        const auto shapes = readShapes(source, tile);
        if (!shapes) return shapes.error();
        add(*shapes, tile.tile, standing);
        if (standing.structures.empty() && standing.windsocks.empty())
            return foundation::Error{source.string(), "has nothing that can stand here",
                                     "give lines of walls, fences, power lines or railways of this place"};
    }
    return standing;
}

} // namespace

foundation::Outcome addStructures(const osgTerrainROAM::core::RoamFile& description, SceneTerrain& scene)
{
    const auto& tile = scene.terrain->tile()->tile;
    const auto standing = standingOf(description, *scene.terrain->tile());
    if (!standing) return standing.error();
    const scenery::GroundHeight ground =
        [query = ground::groundOf(tile)](double eastM, double northM) -> std::optional<double>
    {
        const auto sample = query(eastM, northM);
        return sample ? std::optional(sample->heightM) : std::nullopt;
    };
    std::vector<scenery::PapiUnit> papis;
    for (const SceneRunway& runway : scene.runways)
        addPapis(runway, ground, papis);
    std::vector<glm::dvec3> socks;
    for (const glm::dvec2& place : standing->windsocks)
        if (const auto height = ground(place.x, place.y)) socks.emplace_back(place, *height);
    if (standing->structures.empty() && papis.empty() && socks.empty()) return foundation::success();
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(scene.node);
    std::size_t beyondGround = 0;
    if (!standing->structures.empty())
    {
        if (auto openings = scenery::railOpenings(standing->structures); !openings.empty())
        {
            if (scene.roads)
                for (auto& opening : scenery::tunnelOpenings(*scene.roads))
                    openings.push_back(std::move(opening));
            const auto cells = osgTerrainROAM::core::OpeningCells::build(openings);
            if (!cells) return cells.error();
            scene.terrain->material()->setOpenings(*cells);
        }
        scene.standing.push_back({"structures", scenery::makeStructuresNode(scenery::structureFacets(
                                                    standing->structures, ground, beyondGround))});
        group->addChild(scene.standing.back().node);
    }
    if (standing->unused + beyondGround > 0)
        OSG_NOTICE << "structures: " << standing->unused << " of no known kind, " << beyondGround
                   << " beyond the ground\n";
    scene.airfield = std::make_shared<scenery::AirfieldNode>(papis, socks);
    group->addChild(scene.airfield->node());
    scene.node = group;
    return foundation::success();
}

} // namespace trainer
