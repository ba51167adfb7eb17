// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/Sky.h"

#include <string>

#include <osg/Depth>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Program>
#include <osgSky/Atmosphere>

#include <osgTraversal/DrawOrder>
#include <shaders/scenery.h>

#include "scenery/nodes/NoBound.h"

namespace scenery
{

namespace
{

osg::ref_ptr<osg::Geometry> wholePicture()
{
    osg::ref_ptr<osg::Geometry> rectangle = new osg::Geometry;
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {-1.0F, 1.0F}, {1.0F, 1.0F}})
        corners->push_back({x, y, 0.0F});
    rectangle->setVertexArray(corners);
    rectangle->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, 4));
    rectangle->setUseDisplayList(false);
    rectangle->setUseVertexBufferObjects(true);
    rectangle->setCullingActive(false);
    rectangle->setComputeBoundingBoxCallback(new NoBound);
    return rectangle;
}

} // namespace

osg::ref_ptr<osg::Node> makeSky()
{
    osg::ref_ptr<osg::Geode> sky = new osg::Geode;
    sky->setName("sky");
    sky->setCullingActive(false);
    sky->addDrawable(wholePicture());

    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("sky");
    program->addShader(new osg::Shader(osg::Shader::VERTEX, shaders::kSkyVert));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, std::string("#version 130\n") +
                                                                  osgSky::Atmosphere::glslFunctions() +
                                                                  shaders::kSkyMain));
    osg::StateSet* state = sky->getOrCreateStateSet();
    state->setAttributeAndModes(program);
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 1.0, 1.0, false));
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    state->setRenderBinDetails(osgTraversal::DrawOrder::kSky, "RenderBin");
    return sky;
}

} // namespace scenery
