// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Fog>
#include <osg/Geode>
#include <osg/Group>
#include <osg/Light>
#include <osg/LightModel>
#include <osg/Program>
#include <osg/Shape>
#include <osg/ShapeDrawable>

namespace rendered
{

/// What a mutation may change in the small scene.
struct SceneOptions
{
    float triangleShiftM = 0.0F; ///< sideways move of the one shader-drawn triangle
    float fogFactor = 1.0F;      ///< times the fog's density
    bool withSphere = true;
};

/// A triangle drawn by a shader (GL 2 entry points), a lit ball and box (fixed function) and fog: enough to
/// touch both ways by which OSG reaches GL. Frame: x right, y away, z up, metres; fits a camera at (0, −10,
/// 2) looking along +y.
inline osg::ref_ptr<osg::Geometry> shadedTriangle(float shiftM)
{
    osg::ref_ptr<osg::Geometry> triangle = new osg::Geometry;
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    corners->push_back({-3.0F + shiftM, 0.0F, 0.0F});
    corners->push_back({-0.5F + shiftM, 0.0F, 0.2F});
    corners->push_back({-2.0F + shiftM, 0.0F, 3.0F});
    triangle->setVertexArray(corners);
    triangle->setUseDisplayList(false);
    triangle->setUseVertexBufferObjects(true);
    triangle->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, 3));
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->addShader(new osg::Shader(osg::Shader::VERTEX,
                                       "#version 120\nvarying vec3 place;\n"
                                       "void main() { place = gl_Vertex.xyz;\n"
                                       "gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n"));
    program->addShader(new osg::Shader(
        osg::Shader::FRAGMENT, "#version 120\nvarying vec3 place;\n"
                               "void main() { gl_FragColor = vec4(0.5 + 0.5 * sin(place * 5.0), 1.0); }\n"));
    triangle->getOrCreateStateSet()->setAttributeAndModes(program);
    return triangle;
}

inline osg::ref_ptr<osg::Group> smallScene(const SceneOptions& options = {})
{
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(shadedTriangle(options.triangleShiftM));
    if (options.withSphere)
    {
        osg::ref_ptr<osg::ShapeDrawable> ball =
            new osg::ShapeDrawable(new osg::Sphere(osg::Vec3(1.5F, 1.0F, 1.5F), 1.3F));
        ball->setColor({0.9F, 0.4F, 0.2F, 1.0F});
        geode->addDrawable(ball);
    }
    osg::ref_ptr<osg::ShapeDrawable> ground =
        new osg::ShapeDrawable(new osg::Box(osg::Vec3(0.0F, 20.0F, -0.5F), 60.0F, 60.0F, 0.5F));
    ground->setColor({0.3F, 0.6F, 0.3F, 1.0F});
    geode->addDrawable(ground);
    scene->addChild(geode);

    osg::ref_ptr<osg::Fog> fog = new osg::Fog;
    fog->setMode(osg::Fog::EXP);
    fog->setDensity(0.03F * options.fogFactor);
    fog->setColor({0.6F, 0.7F, 0.8F, 1.0F});
    scene->getOrCreateStateSet()->setAttributeAndModes(fog);
    return scene;
}

} // namespace rendered
