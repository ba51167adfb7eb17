// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <osgRoads/RoadShader>
#include <shaders/osgRoads.h>

namespace osgRoads
{

const char* glslVertexFunctions()
{
    return shaders::kRoadVertexFunctions;
}

const char* glslFragmentFunctions()
{
    static const std::string kFunctions = std::string(shaders::kRoadMarks) + shaders::kRoadDecals +
                                          shaders::kRoadWear + shaders::kRoadMaterials;
    return kFunctions.c_str();
}

void bindRoadAttributes(osg::Program& program)
{
    program.addBindAttribLocation("roadPosition", kPositionAttribute);
    program.addBindAttribLocation("roadPlace", kPlaceAttribute);
    program.addBindAttribLocation("roadNormal", kNormalAttribute);
    program.addBindAttribLocation("roadFlags", kFlagsAttribute);
    program.addBindAttribLocation("roadRows", kRowsAttribute);
}

osg::ref_ptr<osg::Program> makeRoadProgram()
{
    const std::string version = "#version 130\n";
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("osgRoads");
    program->addShader(
        new osg::Shader(osg::Shader::VERTEX, version + glslVertexFunctions() + shaders::kRoadVertexMain));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT,
                                       version + glslFragmentFunctions() + shaders::kRoadFragmentMain));
    bindRoadAttributes(*program);
    return program;
}

} // namespace osgRoads
