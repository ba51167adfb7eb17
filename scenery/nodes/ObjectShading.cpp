// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/ObjectShading.h"

#include <string>

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/Program>

#include <osgPMObjects/ObjectShader>
#include <osgTerrainROAM/Atmosphere>

namespace scenery
{

namespace
{

// Everything relative to the eye: positions of a world tens of kilometres wide do not fit floats.
const char* const kObjectVertexShader = R"(
out vec3 fromEye;      // world axes, origin at the eye
out vec3 normalWorld;
out vec4 colour;
out vec2 textureAt;
out vec3 inObject;
uniform mat4 osg_ViewMatrixInverse;
void main()
{
    inObject = pmPosition();
    vec4 inView = pmInView(inObject);
    mat3 worldFromView = mat3(osg_ViewMatrixInverse);
    fromEye = worldFromView * inView.xyz;
    normalWorld = worldFromView * pmNormalInView(pmNormal());
    colour = pmColour();
    textureAt = pmTexCoord0();
    gl_Position = gl_ProjectionMatrix * inView;
    pmShow();
}
)";

const char* const kObjectFragmentShader = R"(
in vec3 fromEye;
in vec3 normalWorld;
in vec4 colour;
in vec2 textureAt;
in vec3 inObject;
uniform sampler2D objectTexture;
uniform vec4 objectHolesXz;   // of both axes
uniform vec2 objectHolesSize; // radius, distance from the middle
uniform float objectLacquer;
uniform float objectLeaves;   // 1: foliage
uniform float objectTintMask;
void main()
{
    float shownAlpha = pmAlpha();
    float toAxis = min(distance(inObject.xz, objectHolesXz.xy), distance(inObject.xz, objectHolesXz.zw));
    if (toAxis < objectHolesSize.x && abs(inObject.y) > objectHolesSize.y) discard;
    float distanceM = length(fromEye);
    vec3 towards = fromEye / distanceM;
    vec3 normal = normalize(normalWorld);
    if (!gl_FrontFacing && objectLeaves == 0.0) normal = -normal; // open surfaces have two sides
    vec4 texel = texture(objectTexture, textureAt);
    vec4 paint = colour * texel;
    if (objectTintMask > 0.0) paint = vec4(mix(texel.rgb, paint.rgb, texel.a), 1.0);
    vec3 albedo = paint.rgb * paint.rgb;              // the inverse of displayColour's gamma

    float sunCosine = dot(normal, sunDirection());
    float sunHeight = max(sunCosine, 0.0);
    if (objectLeaves > 0.0) sunHeight = max((sunCosine + 0.5) / 1.5, 0.12); // wrapped round the crown, and through it
    vec3 lit = albedo * (sunLight() * sunHeight + ambientLight(normal));
    // Schlick's approximation with the 4 % of lacquer and glass; the mirrored scene is sky above, ground below.
    float fresnel = objectLacquer * (0.04 + 0.96 * pow(1.0 - max(-dot(normal, towards), 0.0), 5.0));
    vec3 mirrored = reflect(towards, normal);
    vec3 scene = mix(0.3 * ambientLight(vec3(0.0, 0.0, -1.0)), skyColour(mirrored), smoothstep(-0.08, 0.08, mirrored.z));
    vec3 highlight = sunLight() * (objectLacquer * 0.35 * pow(max(dot(mirrored, sunDirection()), 0.0), 120.0));
    lit = mix(lit, scene, fresnel) + highlight;
    gl_FragColor = vec4(displayColour(applyHaze(lit, towards, distanceM)), paint.a * shownAlpha);
}
)";

} // namespace

void setObjectShading(osg::Node& node, Finish finish, const FlankHoles& holes)
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("object");
    const std::string version = "#version 130\n";
    program->addShader(new osg::Shader(osg::Shader::VERTEX,
                                       version + osgPMObjects::glslVertexFunctions() + kObjectVertexShader));
    program->addShader(new osg::Shader(
        osg::Shader::FRAGMENT, version + osgPMObjects::glslFragmentFunctions() +
                                   osgTerrainROAM::Atmosphere::glslFunctions() + kObjectFragmentShader));
    osgPMObjects::bindObjectAttributes(*program);
    osg::StateSet* state = node.getOrCreateStateSet();
    state->setAttributeAndModes(program);
    state->addUniform(new osg::Uniform("objectTexture", 0));
    state->addUniform(new osg::Uniform("objectLacquer", finish == Finish::lacquered ? 1.0F : 0.0F));
    state->addUniform(new osg::Uniform("objectLeaves", finish == Finish::foliage ? 1.0F : 0.0F));
    state->addUniform(new osg::Uniform("objectTintMask", 0.0F));
    state->addUniform(new osg::Uniform("objectHolesXz", osg::Vec4f(holes.firstXz.x(), holes.firstXz.y(),
                                                                   holes.secondXz.x(), holes.secondXz.y())));
    state->addUniform(new osg::Uniform("objectHolesSize", osg::Vec2f(holes.radiusM, holes.innerYM)));
    state->setTextureAttributeAndModes(0, osgPMObjects::whiteTexture());
    if (finish != Finish::seeThrough) return;
    state->setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LESS, 0.0, 1.0, false));
    state->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
}

} // namespace scenery
