// SPDX-License-Identifier: Apache-2.0
#include "SceneRoads.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <foundation/KeptFrom.h>
#include <foundation/Threads.h>

#include <osg/Group>
#include <osg/NodeVisitor>
#include <osg/Notify>

#include <osgRoads/core/surface/BuildRoadMesh.h>
#include <osgTerrainROAM/core/LoadTerrain.h>

#include <osgRoads/RoadDrawable>

#include "SceneLamps.h"
#include "SceneMap.h"
#include "SceneStrip.h"
#include "SceneStructures.h"
#include "scenery/ground/TileGround.h"
#include "scenery/nodes/RoadShading.h"
#include "scenery/nodes/RoadThingsNode.h"
#include "scenery/roads/CutRoads.h"
#include "scenery/roads/HeightOnRoads.h"
#include "scenery/roads/LayRoads.h"
#include "scenery/roads/RoadGround.h"
#include "scenery/roads/TunnelOpenings.h"
#include "scenery/roads/things/ThingObstacles.h"

namespace trainer
{

namespace
{

using osgRoads::core::PlacedNetwork;
using osgTerrainROAM::core::RoamFile;
using osgTerrainROAM::core::RoamTile;

/// Nearer than this the roads' mesh hides their ribbons on the ground: it begins to fade out later.
const double kRibbonsFromM = 0.8 * osgRoads::core::RoadViewSettings().farthestM;

constexpr double kStripSpacingM = 5.0; ///< between the samples of a strip

/// The height of the bare ground of a tile, which must outlive it.
foundation::HeightInPlan bareGround(const RoamTile& tile)
{
    return ground::groundOf(tile.tile).heights();
}

/// The drawn surface of roads, and what stands beside and over them: signs, lights, posts, rails, bridges and
/// tunnels.
struct RoadParts
{
    std::shared_ptr<const osgRoads::core::PagedRoadMesh> mesh;
    std::unique_ptr<scenery::RoadThingsNode> things;
    simulation::ObstacleList obstacles;
};

/// What a scene is made of besides its land. Each is absent until it is made, and null or empty where there
/// is none.
struct PartsOfScene
{
    std::optional<foundation::Result<RoadParts>> roads;
    std::optional<foundation::Result<MapScenery>> map;
    std::optional<foundation::Result<MadeStructures>> structures;
    std::optional<foundation::Result<SceneAirfields>> airfields;
    scenery::roads::RoadThings signs;
};

/// Roads on the ground of a tile. `mark`: of what they follow from besides the tile (markOfRoads()).
struct LaidRoads
{
    const scenery::SceneRoads& roads;
    std::optional<foundation::ContentMark> mark;
};

foundation::Result<RoadParts> makeRoadParts(const RoamTile& tile, const LaidRoads& laid,
                                            const foundation::KeptFrom& kept, bool wantsObstacles)
{
    const scenery::SceneRoads& roads = laid.roads;
    if (!roads.placed) return RoadParts();
    RoadParts parts;
    parts.mesh = scenery::roadMeshOf(roads, laid.mark, kept);
    const scenery::roads::RoadThings beside =
        scenery::roads::placeRoadThings(*roads.placed, bareGround(tile));
    if (wantsObstacles) scenery::roads::addObstacles(beside, parts.obstacles);
    auto things = scenery::RoadThingsNode::create(beside);
    if (!things) return things.error();
    parts.things = std::move(*things);
    return parts;
}

/// The land with what is painted on it, cut open where roads enter tunnels.
foundation::Result<osg::ref_ptr<osgTerrainROAM::RoamTerrain>>
makeLand(const RoamFile& description, const std::shared_ptr<RoamTile>& tile, const LaidRoads& laid,
         const std::vector<osgTerrainROAM::core::GroundFeature>& painted, const foundation::KeptFrom& kept)
{
    const scenery::SceneRoads& roads = laid.roads;
    osgTerrainROAM::MoreFeatures more{painted};
    if (roads.placed)
        more = {painted, [placed = roads.placed] { return scenery::farRoads(*placed); }, kRibbonsFromM,
                laid.mark};
    auto terrain = osgTerrainROAM::makeTerrain(description, tile, more, kept);
    if (!terrain || !roads.placed) return terrain;
    const auto openings = osgTerrainROAM::core::OpeningCells::build(scenery::tunnelOpenings(*roads.placed));
    if (!openings) return openings.error();
    (*terrain)->material()->setOpenings(*openings);
    return terrain;
}

/// Adds the roads' surface and what stands beside them to a scene, and tells what is wrong with their file.
void addRoads(RoadParts made, const scenery::SceneRoads& roads, SceneTerrain& scene)
{
    for (const std::string& note : roads.notes)
        OSG_NOTICE << note << '\n';
    const std::string unreached =
        osgRoads::core::unreachedMessage(made.mesh->outline(), roads.placed->network(), roads.file);
    if (!unreached.empty()) OSG_NOTICE << unreached << '\n';
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(scene.node);
    group->addChild(scenery::makeRoadNode(std::move(made.mesh), scene.terrain));
    group->addChild(made.things->node());
    scene.node = group;
    scene.roads = roads.placed;
    scene.roadsFile = roads.file;
    scene.roadThings = std::move(made.things);
}

/// Adds the buildings and objects of a description, which are taken, and tells what of them could not be
/// used.
void addMap(MapScenery& map, SceneTerrain& scene)
{
    for (const std::string& note : map.notes)
        OSG_NOTICE << note << '\n';
    if (map.standing.empty()) return;
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(scene.node);
    for (const StandingPart& part : map.standing)
        group->addChild(part.node);
    scene.standing = std::move(map.standing);
    scene.houses = map.houses;
    scene.node = group;
}

/// Adds the lamps of settlements.
void addLamps(MapScenery map, const scenery::MappedLamps& mapped, const LaidRoads& laid,
              const foundation::KeptFrom& kept, SceneTerrain& scene)
{
    auto ground = ground::groundOf(scene.terrain->tile()->tile).heights();
    scene.settlements =
        settlementLights(std::move(map), mapped, scene.roads.get(), std::move(ground), laid.mark, kept);
    if (!scene.settlements) return;
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(scene.node);
    group->addChild(scene.settlements->node());
    scene.standing.push_back({"lamps", scene.settlements->node()});
    scene.node = group;
}

/// Makes all that stands on a tile, its land in this thread and the rest in others: none needs another. The
/// order in which they end changes neither the scene nor what is told.
foundation::Result<SceneTerrain> makeScene(const RoamFile& description, const std::shared_ptr<RoamTile>& tile,
                                           const scenery::SceneRoads& roads,
                                           const std::vector<osgTerrainROAM::core::GroundFeature>& painted,
                                           const TerrainRequest& request)
{
    OpeningClock& opening = *request.opening;
    const bool wantsObstacles = request.wantsObstacles;
    const auto kept = foundation::KeptFrom::ofUser(tile->mark());
    const LaidRoads laid{roads, kept && roads.placed ? scenery::markOfRoads(description) : std::nullopt};
    PartsOfScene parts;
    foundation::Threads beside;
    beside.run(
        [&]
        {
            parts.map.emplace(
                makeMapScenery(description, *tile, bareGround(*tile), roads.placed.get(), wantsObstacles));
        });
    beside.run([&] { parts.roads.emplace(makeRoadParts(*tile, laid, kept, wantsObstacles)); });
    beside.run(
        [&]
        {
            parts.structures.emplace(makeStructures(description, *tile, wantsObstacles));
            parts.airfields.emplace(sceneAirfields(description, *tile));
            if (*parts.airfields) parts.signs = airfieldSigns(**parts.airfields, tile->tile);
        });
    const auto terrain = makeLand(description, tile, laid, painted, kept);
    opening.end("land");
    beside.join();
    if (!terrain) return terrain.error();
    if (!*parts.roads) return parts.roads->error();
    if (!*parts.map) return parts.map->error();
    if (!*parts.airfields) return parts.airfields->error();
    if (!*parts.structures) return parts.structures->error();
    SceneTerrain scene{*terrain, *terrain, nullptr};
    if (wantsObstacles)
    {
        simulation::ObstacleList obstacles = std::move((*parts.roads)->obstacles);
        obstacles.add((*parts.map)->obstacles);
        obstacles.add((*parts.structures)->obstacles);
        scenery::roads::addObstacles(parts.signs, obstacles);
        scene.obstacles = std::make_shared<const simulation::ObstacleMap>(std::move(obstacles));
    }
    if (roads.placed) addRoads(std::move(**parts.roads), roads, scene);
    addMap(**parts.map, scene);
    addLamps(std::move(**parts.map), (*parts.structures)->lamps, laid, kept, scene);
    if (const auto added = addStructures(**parts.structures, **parts.airfields, parts.signs, scene); !added)
        return added.error();
    opening.end("what stands on it");
    return scene;
}

/// Returns the land cover of ground that is made up for a network: meadow. Nothing is planted on it, so it
/// shows no wood either.
osgTerrainROAM::core::CoverMap meadow()
{
    return {2, 2, std::vector(4, osgTerrainROAM::core::GroundKind::meadow), {}};
}

/// Visits the drawables of roads.
class RoadSetter : public osg::NodeVisitor
{
public:
    explicit RoadSetter(double errorTolerancePx)
        : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN), _errorTolerancePx(errorTolerancePx)
    {
    }

    void apply(osg::Drawable& drawable) override
    {
        auto* road = dynamic_cast<osgRoads::RoadDrawable*>(&drawable);
        if (!road) return;
        osgRoads::core::RoadViewSettings settings;
        settings.tolerancePx *= _errorTolerancePx;
        if (const auto set = road->setSettings(settings); !set) OSG_WARN << set.error().message() << '\n';
    }

private:
    double _errorTolerancePx;
};

} // namespace

simulation::GroundProvider groundWithRoads(simulation::GroundProvider ground,
                                           std::shared_ptr<const PlacedNetwork> roads)
{
    return [ground = std::move(ground), roads = std::move(roads)](
               double eastM, double northM, double fromM) -> std::optional<simulation::GroundSample>
    {
        const auto bare = ground(eastM, northM, fromM);
        if (!bare) return bare;
        return simulation::GroundSample{
            scenery::heightOnRoads(*roads, {eastM, northM, bare->heightM}, fromM)};
    };
}

foundation::Result<SceneTerrain> makeTerrainWithRoads(const RoamFile& asked, const TerrainRequest& request)
{
    RoamFile description = asked;
    const std::optional<StripRequest>& strip = request.strip;
    if (strip && !description.finestSpacingM) description.finestSpacingM = kStripSpacingM;
    const foundation::KeptResults kept = foundation::KeptResults::ofUser();
    const auto loaded = scenery::loadRoadTile(description, &kept);
    if (!loaded) return loaded.error();
    const auto& [tile, roads] = *loaded;
    std::vector<osgTerrainROAM::core::GroundFeature> painted;
    if (strip)
    {
        const auto runway = layStrip(tile, *strip);
        if (!runway) return runway.error();
        painted.push_back(*runway);
    }
    request.opening->end("ground");
    return makeScene(description, tile, roads, painted, request);
}

foundation::Result<SceneTerrain> openNetwork(const std::filesystem::path& file, const TerrainRequest& request)
{
    auto ground = scenery::makeRoadGround(file);
    if (!ground) return ground.error();
    RoamFile description;
    description.placement = osgTerrainROAM::core::Placement::planar;
    description.showsVoids = request.showsVoids;
    description.land.water =
        osgTerrainROAM::core::WaterRule::none; // networks know no sea; many lie at height 0
    osgTerrainROAM::core::PlacedTileOptions options{.placement = description.placement};
    options.gridExponent = osgTerrainROAM::core::gridExponentFor(ground->field, ground->roadSampleM);
    const auto tile = std::make_shared<RoamTile>(
        osgTerrainROAM::core::PlacedTile(std::move(ground->field), std::move(options)));
    osgTerrainROAM::core::TileEditor editor(tile);
    if (const auto cut = scenery::cutRoads(editor, *ground->roads.placed); !cut) return cut.error();
    auto scene = makeScene(description, tile, ground->roads, {}, request);
    if (scene) scene->terrain->material()->setCover(meadow());
    return scene && request.inRoadsFrame ? moved(std::move(*scene), ground->cornerM) : scene;
}

void setRoadTolerance(osg::Node& scene, double errorTolerancePx)
{
    RoadSetter setter(errorTolerancePx);
    scene.accept(setter);
}

} // namespace trainer
