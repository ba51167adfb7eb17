// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/RoadShading.h"

#include <string>

#include <osg/Geode>
#include <osg/Program>

#include <osgRoads/RoadDrawable>
#include <osgRoads/RoadShader>
#include <osgTerrainROAM/Atmosphere>
#include <shaders/scenery.h>

namespace scenery
{

namespace
{

osg::ref_ptr<osg::Program> makeProgram()
{
    const std::string version = "#version 130\n";
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("road");
    program->addShader(new osg::Shader(osg::Shader::VERTEX,
                                       version + osgRoads::glslVertexFunctions() + shaders::kRoadVertexMain));
    program->addShader(new osg::Shader(
        osg::Shader::FRAGMENT, version + osgRoads::glslFragmentFunctions() +
                                   osgTerrainROAM::Atmosphere::glslFunctions() + shaders::kRoadFragmentMain));
    osgRoads::bindRoadAttributes(*program);
    return program;
}

} // namespace

osg::ref_ptr<osg::Node> makeRoadNode(std::shared_ptr<const osgRoads::core::RoadMesh> mesh)
{
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->setName("roads");
    geode->addDrawable(new osgRoads::RoadDrawable(std::move(mesh)));
    geode->getOrCreateStateSet()->setAttributeAndModes(makeProgram());
    return geode;
}

} // namespace scenery
