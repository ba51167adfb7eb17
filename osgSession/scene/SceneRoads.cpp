// SPDX-License-Identifier: Apache-2.0
#include "SceneRoads.h"

#include <string>
#include <utility>

#include <foundation/KeptFrom.h>

#include <osg/Group>
#include <osg/NodeVisitor>
#include <osg/Notify>

#include <osgRoads/core/surface/BuildRoadMesh.h>
#include <osgTerrainROAM/core/LoadTerrain.h>

#include <osgRoads/RoadDrawable>

#include "SceneMap.h"
#include "SceneStrip.h"
#include "scenery/ground/TileGround.h"
#include "scenery/nodes/RoadShading.h"
#include "scenery/nodes/RoadThingsNode.h"
#include "scenery/roads/CutRoads.h"
#include "scenery/roads/HeightOnRoads.h"
#include "scenery/roads/LayRoads.h"
#include "scenery/roads/RoadGround.h"
#include "scenery/roads/TunnelOpenings.h"

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

/// The height of the bare ground of a terrain, which must outlive it.
HeightOfGround bareGround(const osgTerrainROAM::RoamTerrain& terrain)
{
    return [query = ground::groundOf(terrain.tile()->tile)](double x, double y) -> std::optional<double>
    {
        const auto sample = query(x, y);
        return sample ? std::optional(sample->heightM) : std::nullopt;
    };
}

/// Signs, lights, posts, rails, bridges and tunnels.
foundation::Result<std::unique_ptr<scenery::RoadThingsNode>>
makeThings(const osgTerrainROAM::RoamTerrain& terrain, const PlacedNetwork& roads)
{
    return scenery::RoadThingsNode::create(scenery::roads::placeRoadThings(roads, bareGround(terrain)));
}

/// Adds the buildings and objects of a description.
foundation::Result<SceneTerrain> withMap(const RoamFile& description, SceneTerrain scene,
                                         OpeningClock& opening)
{
    if (description.buildings.empty() && description.objects.empty()) return scene;
    const osg::ref_ptr<osg::Group> group = new osg::Group;
    group->addChild(scene.node);
    const auto added = addMapScenery(description, *scene.terrain->tile(), bareGround(*scene.terrain),
                                     scene.roads.get(), scene.standing);
    if (!added) return added.error();
    for (const StandingPart& part : scene.standing)
        group->addChild(part.node);
    scene.node = group;
    opening.end("map");
    return scene;
}

/// Adds the roads' surface and what stands beside them to a terrain, and tells what is wrong with their file.
foundation::Result<SceneTerrain> withRoads(osg::ref_ptr<osgTerrainROAM::RoamTerrain> terrain,
                                           const scenery::SceneRoads& roads, osgRoads::core::RoadMesh made,
                                           OpeningClock& opening)
{
    for (const std::string& note : roads.notes)
        OSG_NOTICE << note << '\n';
    auto mesh = std::make_shared<const osgRoads::core::RoadMesh>(std::move(made));
    const std::string unreached =
        osgRoads::core::unreachedMessage(*mesh, roads.placed->network(), roads.file);
    if (!unreached.empty()) OSG_NOTICE << unreached << '\n';
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(terrain);
    scene->addChild(scenery::makeRoadNode(std::move(mesh), terrain));
    auto things = makeThings(*terrain, *roads.placed);
    if (!things) return things.error();
    scene->addChild((*things)->node());
    opening.end("roads");
    return SceneTerrain{scene, terrain, roads.placed, std::move(*things)};
}

foundation::Result<SceneTerrain> makeScene(const RoamFile& description, const std::shared_ptr<RoamTile>& tile,
                                           const scenery::SceneRoads& roads,
                                           const std::vector<osgTerrainROAM::core::GroundFeature>& painted,
                                           OpeningClock& opening)
{
    const auto kept = foundation::KeptFrom::ofUser(tile->mark());
    auto terrain = osgTerrainROAM::makeTerrain(
        description, tile, {painted, scenery::farRoads(*roads.placed), kRibbonsFromM}, kept);
    if (!terrain) return terrain.error();
    const auto openings = osgTerrainROAM::core::OpeningCells::build(scenery::tunnelOpenings(*roads.placed));
    if (!openings) return openings.error();
    (*terrain)->material()->setOpenings(*openings);
    opening.end("land");
    return withRoads(*terrain, roads, scenery::roadMeshOf(description, roads, kept), opening);
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
    OpeningClock& opening = *request.opening;
    if (strip && !description.finestSpacingM) description.finestSpacingM = kStripSpacingM;
    const foundation::KeptResults kept = foundation::KeptResults::ofUser();
    if (description.roads.empty() && !strip)
    {
        const auto bare = osgTerrainROAM::core::loadRoamTile(description, &kept);
        if (!bare) return bare.error();
        opening.end("ground");
        auto terrain = osgTerrainROAM::makeTerrain(description, *bare, {},
                                                   foundation::KeptFrom::ofUser((*bare)->mark()));
        if (!terrain) return terrain.error();
        opening.end("land");
        return withMap(description, SceneTerrain{terrain->get(), *terrain, nullptr}, opening);
    }
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
    opening.end("ground");
    if (roads.placed)
    {
        auto scene = makeScene(description, tile, roads, painted, opening);
        return scene ? withMap(description, *std::move(scene), opening) : scene;
    }
    auto terrain = osgTerrainROAM::makeTerrain(description, tile, {std::move(painted), {}},
                                               foundation::KeptFrom::ofUser(tile->mark()));
    if (!terrain) return terrain.error();
    opening.end("land");
    return withMap(description, SceneTerrain{terrain->get(), *terrain, nullptr}, opening);
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
    auto scene = makeScene(description, tile, ground->roads, {}, *request.opening);
    if (scene) scene->terrain->material()->setCover(meadow());
    return scene && request.inRoadsFrame ? moved(std::move(*scene), ground->cornerM) : scene;
}

void setRoadTolerance(osg::Node& scene, double errorTolerancePx)
{
    RoadSetter setter(errorTolerancePx);
    scene.accept(setter);
}

} // namespace trainer
