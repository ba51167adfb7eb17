// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/RoadShading.h"

#include <string>

#include <osg/Geode>
#include <osg/Program>
#include <osgSky/Atmosphere>

#include <osgRoads/RoadDrawable>
#include <osgRoads/RoadShader>
#include <shaders/scenery.h>

namespace scenery
{

namespace
{

constexpr int kFirstRoadUnit = 13;
constexpr double kSlopeM = 100.0; ///< over which the grid's directions are measured

osg::ref_ptr<osg::Program> makeProgram()
{
    const std::string version = "#version 130\n";
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("road");
    program->addShader(new osg::Shader(osg::Shader::VERTEX,
                                       version + osgRoads::glslVertexFunctions() + shaders::kRoadVertexMain));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, version + osgRoads::glslFragmentFunctions() +
                                                                  osgSky::Atmosphere::glslFunctions() +
                                                                  shaders::kRoadFragmentMain));
    osgRoads::bindRoadAttributes(*program);
    return program;
}

/// Lets strips of grass look as the terrain's ground: its grid coordinates are linear over a network, to a
/// part of a sample.
osg::ref_ptr<osg::StateSet> makeGroundState(osgRoads::RoadDrawable& drawable,
                                            osgTerrainROAM::RoamTerrain& terrain)
{
    const osgRoads::core::RoadMesh& mesh = drawable.mesh()->outline();
    const auto& frame = terrain.tile()->tile.frame();
    const glm::dvec2 at(mesh.origin);
    const glm::dvec2 grid = frame.gridNear(at);
    const glm::dvec2 east = (frame.gridNear(at + glm::dvec2(kSlopeM, 0.0)) - grid) / kSlopeM;
    const glm::dvec2 north = (frame.gridNear(at + glm::dvec2(0.0, kSlopeM)) - grid) / kSlopeM;
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->addUniform(new osg::Uniform("roadGridOrigin", osg::Vec2f(osg::Vec2d(grid.x, grid.y))));
    state->addUniform(
        new osg::Uniform("roadGridFromPlan", osg::Vec4f(osg::Vec4d(east.x, east.y, north.x, north.y))));
    // The names by which the road is given what depends on the eye. One grain serves both: OpenGL 3.3
    // guarantees 16 samplers.
    const std::string names =
        "#define terrainEyeWrapped roadEyeWrapped\n#define terrainEyeWraps roadEyeWraps\n"
        "#define roadGrain terrainGrain\n"
        "#define terrainWorldFromLocal roadWorldFromLocal\n";
    const auto finish =
        [own = osg::ref_ptr<osg::StateSet>(drawable.getStateSet())](osg::StateSet& to, osg::Program& program)
    {
        osgRoads::bindRoadAttributes(program);
        int unit = kFirstRoadUnit; // the terrain's textures have the road's units
        for (const auto& [name, ownUnit] :
             {std::pair{"roadMarks", osgRoads::kMarksUnit}, {"roadDecals", osgRoads::kDecalsUnit}})
        {
            to.setTextureAttributeAndModes(unit,
                                           own->getTextureAttribute(ownUnit, osg::StateAttribute::TEXTURE));
            to.getOrCreateUniform(name, osg::Uniform::INT)->set(unit++);
        }
    };
    terrain.material()->lendLook(
        state,
        {std::string(osgRoads::glslVertexFunctions()) + shaders::kRoadGroundVertexMain,
         std::string(osgRoads::glslFragmentFunctions()) + shaders::kRoadGroundFragmentMain, finish, names});
    return state;
}

} // namespace

osg::ref_ptr<osg::Node> makeRoadNode(std::shared_ptr<const osgRoads::core::RoadMesh> mesh,
                                     osgTerrainROAM::RoamTerrain* terrain)
{
    return makeRoadNode(std::make_shared<const osgRoads::core::PagedRoadMesh>(std::move(mesh)), terrain);
}

osg::ref_ptr<osg::Node> makeRoadNode(std::shared_ptr<const osgRoads::core::PagedRoadMesh> mesh,
                                     osgTerrainROAM::RoamTerrain* terrain)
{
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setName("roads");
    const osg::ref_ptr<osgRoads::RoadDrawable> drawable = new osgRoads::RoadDrawable(std::move(mesh));
    if (terrain && terrain->material()) drawable->setGroundState(makeGroundState(*drawable, *terrain));
    geode->addDrawable(drawable);
    geode->getOrCreateStateSet()->setAttributeAndModes(makeProgram());
    return geode;
}

} // namespace scenery
