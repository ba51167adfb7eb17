// SPDX-License-Identifier: Apache-2.0
#include <bake/BakedState.h>
#include <bake/Finish.h>

#include <osg/NodeVisitor>

#include <osgMultiTriangulation/MtDrawable>
#include <osgPMObjects/ObjectShader>
#include <osgRoads/RoadDrawable>
#include <osgRoads/RoadShader>
#include <osgTerrainROAM/RoamTerrain>

#include "Compositions.h"
#include "RenderedScene.h"
#include "SyntheticField.h"
#include "scenery/nodes/Clouds.h"
#include "scenery/nodes/FallingDrops.h"
#include "scenery/nodes/InteriorShading.h"
#include "scenery/nodes/LampGlow.h"
#include "scenery/nodes/LightPoints.h"
#include "scenery/nodes/NightSky.h"
#include "scenery/nodes/ObjectShading.h"
#include "scenery/nodes/RoadShading.h"
#include "scenery/nodes/RoadThingsNode.h"
#include "scenery/nodes/SettlementLights.h"
#include "scenery/nodes/Sky.h"
#include "scenery/nodes/SkyShadeNode.h"
#include "scenery/nodes/SunShadow.h"

namespace shadercheck
{

namespace
{

const osg::Program* programOf(const osg::StateSet* state)
{
    return state ? dynamic_cast<const osg::Program*>(state->getAttribute(osg::StateAttribute::PROGRAM))
                 : nullptr;
}

osg::ref_ptr<const osg::Program> bakedProgram()
{
    osgPMObjects::core::BakedMaps maps;
    maps.sizePx = 1;
    maps.colours.resize(1);
    maps.normals.resize(1);
    const osgPMObjects::BakedLook look(maps, 1);
    const osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    return programOf(look.stateFor(*state, osgPMObjects::Finish(), true));
}

/// Of verges that look as the ground of a terrain does, which has features, cover, openings and a season.
osg::ref_ptr<const osg::Program> roadGroundProgram()
{
    using namespace osgTerrainROAM;
    const auto tile =
        std::make_shared<core::RoamTile>(core::PlacedTile(testsupport::hills(9, 9), core::Placement::planar));
    const osg::ref_ptr<TerrainMaterial> material = new TerrainMaterial(tile->tile, Climate{});
    const osg::ref_ptr<RoamTerrain> terrain = new RoamTerrain(tile, material);
    const osg::ref_ptr<osg::Node> road =
        scenery::makeRoadNode(std::make_shared<osgRoads::core::RoadMesh>(), terrain);
    material->setFeatures(core::FeatureCells({}));
    core::CoverMap cover;
    cover.width = cover.height = 2;
    cover.kinds.assign(4, core::GroundKind::meadow);
    material->setCover(cover);
    material->setOpenings(*core::OpeningCells::build({}));
    (void)material->setSeason(0.9);
    const auto* drawable = dynamic_cast<const osgRoads::RoadDrawable*>(road->asGeode()->getDrawable(0));
    return programOf(drawable->groundState());
}

/// Of a multi-triangulation on a terrain that has all that a ground may have.
osg::ref_ptr<const osg::Program> triangulationProgram()
{
    using namespace osgTerrainROAM;
    const core::PlacedTile tile(testsupport::hills(9, 9), core::Placement::planar);
    const osg::ref_ptr<TerrainMaterial> material = new TerrainMaterial(tile, Climate{});
    const osg::ref_ptr<osgMultiTriangulation::MtDrawable> drawable = new osgMultiTriangulation::MtDrawable;
    drawable->takeLook(*material);
    material->setFeatures(core::FeatureCells({}));
    material->setOpenings(*core::OpeningCells::build({}));
    (void)material->setSeason(0.9);
    return programOf(drawable->getStateSet());
}

/// Collects the programs of all states of a graph.
class ProgramsOf : public osg::NodeVisitor
{
public:
    explicit ProgramsOf(std::vector<NamedProgram>& programs)
        : osg::NodeVisitor(osg::NodeVisitor::TRAVERSE_ALL_CHILDREN), _programs(programs)
    {
        setNodeMaskOverride(~0U); // what is hidden now, too
    }

    void apply(osg::Node& node) override
    {
        if (const osg::Program* const program = programOf(node.getStateSet()))
            _programs.push_back({program->getName(), program});
        traverse(node);
    }

private:
    std::vector<NamedProgram>& _programs;
};

/// Of clouds, stars and the moon.
void addSkyPrograms(std::vector<NamedProgram>& programs)
{
    ProgramsOf visitor(programs);
    scenery::Clouds clouds;
    clouds.setLayers({simulation::CloudLayer{}}, 0.0);
    clouds.node().accept(visitor);
    for (const bool isAmong : {false, true})
        programs.push_back({"clouds laid over the scene", scenery::makeCloudSheetProgram(isAmong)});
    scenery::NightSky night;
    night.node().accept(visitor);
}

} // namespace

std::vector<NamedProgram> objectPrograms()
{
    const osg::ref_ptr<osg::Node> object = new osg::Group;
    scenery::setObjectShading(*object, scenery::Finish::matt);
    std::vector<NamedProgram> programs{
        {"object", osgPMObjects::makeObjectProgram()},
        {"baked object", bakedProgram()},
        {"object under the atmosphere", programOf(object->getStateSet())},
        {"road", osgRoads::makeRoadProgram()},
        {"road under the atmosphere",
         programOf(scenery::makeRoadNode(std::make_shared<osgRoads::core::RoadMesh>())->getStateSet())},
        {"verge of a road on a terrain", roadGroundProgram()},
        {"multi-triangulation on a terrain", triangulationProgram()},
        {"road lamp", scenery::makeRoadLampProgram()},
        {"interior of a vehicle", scenery::makeInteriorProgram()},
        {"mirror", scenery::makeMirrorProgram()},
        {"light point", scenery::makeLightPointProgram()},
        {"lit window", scenery::makeWindowProgram()},
        {"ground below a lamp", scenery::makeLampPoolProgram()},
        {"lamp glow", scenery::makeLampGlowProgram()},
        {"falling drops", scenery::makeFallingDropsProgram()},
        {"sun shadow", scenery::makeSunShadowProgram()},
        {"sky shade", scenery::makeSkyShadeProgram()},
        {"sky", programOf(scenery::makeSky()->getStateSet())},
        {"tests' triangle", programOf(rendered::shadedTriangle(0.0F)->getStateSet())}};
    addSkyPrograms(programs);
    return programs;
}

} // namespace shadercheck
