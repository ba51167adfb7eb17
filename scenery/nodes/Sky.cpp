// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/Sky.h"

#include <string>

#include <osg/Depth>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/Program>

namespace scenery
{

namespace
{

/// After the opaque bin (0), so that hidden sky costs nothing; before transparent things (10).
constexpr int kSkyBin = 5;

// The rectangle lies on the far plane; a pixel's direction is exact at any field of view, on or off the axis.
const char* const kSkyVertexShader = R"(#version 130
out vec3 direction;
uniform mat4 osg_ViewMatrixInverse;
void main()
{
    vec4 farPoint = gl_ProjectionMatrixInverse * vec4(gl_Vertex.xy, 1.0, 1.0);
    direction = mat3(osg_ViewMatrixInverse) * (farPoint.xyz / farPoint.w);
    gl_Position = vec4(gl_Vertex.xy, 1.0, 1.0);
}
)";

const char* const kSkyFragmentShader = R"(
in vec3 direction;

float hashOf(vec3 cell)
{
    return fract(sin(dot(cell, vec3(127.1, 311.7, 74.7))) * 43758.5453);
}

// At most one star in each cell of a grid around the unit sphere, drawn about a pixel and a half wide. A star that
// comes to lie near or beyond its cell's walls is left out, for its neighbour would not draw its other half.
vec3 stars(vec3 towards, float pixelAngle)
{
    const float kCells = 40.0;
    vec3 cell = floor(towards * kCells);
    if (hashOf(cell) < 0.35) return vec3(0.0);
    vec3 jitter = vec3(hashOf(cell + 1.0), hashOf(cell + 2.0), hashOf(cell + 3.0));
    vec3 place = normalize(cell + jitter);
    vec3 inCell = place * kCells - cell;
    if (any(lessThan(inCell, vec3(0.1))) || any(greaterThan(inCell, vec3(0.9)))) return vec3(0.0);
    float away = length(towards - place) / pixelAngle;
    float magnitude = hashOf(cell + 4.0);
    return vec3(0.9, 0.95, 1.0) * (0.6 * magnitude * magnitude * magnitude * exp(-away * away));
}

void main()
{
    vec3 towards = normalize(direction);
    vec3 colour = skyColour(towards) + sunDisc(towards);
    float night = smoothstep(-0.10, -0.25, sunDirection().z);
    if (night > 0.0 && towards.z > 0.0)
        colour += night * smoothstep(0.0, 0.25, towards.z) * stars(towards, max(0.7 * length(fwidth(towards)), 1e-6));
    gl_FragColor = vec4(displayColour(colour), 1.0);
}
)";

/// The rectangle has no place in the world, and no share in the bounds of the scene.
struct NoBound : public osg::Drawable::ComputeBoundingBoxCallback
{
    osg::BoundingBox computeBound(const osg::Drawable&) const override { return {}; }
};

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
    program->addShader(new osg::Shader(osg::Shader::VERTEX, kSkyVertexShader));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT,
                                       std::string("#version 130\n") +
                                           osgTerrainROAM::Atmosphere::glslFunctions() + kSkyFragmentShader));
    osg::StateSet* state = sky->getOrCreateStateSet();
    state->setAttributeAndModes(program);
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 1.0, 1.0, false));
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    state->setRenderBinDetails(kSkyBin, "RenderBin");
    return sky;
}

} // namespace scenery
