// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <osg/Image>
#include <osg/Uniform>

#include <osgPMObjects/ObjectShader>

namespace osgPMObjects
{

namespace
{

const char* const kVertexMain = R"(
out vec3 normalInView;
out vec3 inView;
out vec4 colour;
out vec2 textureAt;
void main()
{
    vec4 placed = pmInView(pmPosition());
    inView = placed.xyz;
    normalInView = pmNormalInView(pmNormal());
    colour = pmColour();
    textureAt = (gl_TextureMatrix[0] * vec4(pmTexCoord0(), 0.0, 1.0)).xy;
    gl_Position = gl_ProjectionMatrix * placed;
    pmShow();
}
)";

const char* const kFragmentMain = R"(
in vec3 normalInView;
in vec3 inView;
in vec4 colour;
in vec2 textureAt;
uniform sampler2D pmTexture;
void main()
{
    float alpha = pmAlpha();
    vec3 normal = normalize(normalInView);
    vec4 light = gl_LightSource[0].position;
    vec3 towards = normalize(light.w == 0.0 ? light.xyz : light.xyz - inView);
    vec3 ambient = gl_LightModel.ambient.rgb + gl_LightSource[0].ambient.rgb;
    vec3 diffuse = max(dot(normal, towards), 0.0) * gl_LightSource[0].diffuse.rgb;
    vec4 paint = colour * texture(pmTexture, textureAt);
    gl_FragColor = vec4(min(paint.rgb * (ambient + diffuse), vec3(1.0)), paint.a * alpha);
}
)";

} // namespace

osg::ref_ptr<osg::Texture2D> whiteTexture()
{
    const osg::ref_ptr<osg::Image> pixel = new osg::Image;
    pixel->allocateImage(1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    for (int i = 0; i < 4; ++i)
        pixel->data()[i] = 255;
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(pixel);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    return texture;
}

void bindObjectAttributes(osg::Program& program)
{
    program.addBindAttribLocation("pmShown", kShownAttribute);
    program.addBindAttribLocation("pmPlace", kPlaceAttribute);
    program.addBindAttribLocation("pmTurn", kTurnAttribute);
    program.addBindAttribLocation("pmTargetPosition", kTargetPositionAttribute);
    program.addBindAttribLocation("pmTargetNormal", kTargetNormalAttribute);
    program.addBindAttribLocation("pmTargetColour", kTargetColourAttribute);
    program.addBindAttribLocation("pmTargetTexCoords", kTargetTexCoordsAttribute);
    program.addBindAttribLocation("pmLeafOffset", kLeafOffsetAttribute);
    program.addBindAttribLocation("pmLeafScale", kLeafScaleAttribute);
}

osg::ref_ptr<osg::Program> makeObjectProgram()
{
    const std::string version = "#version 130\n";
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName("osgPMObjects");
    program->addShader(new osg::Shader(osg::Shader::VERTEX, version + glslVertexFunctions() + kVertexMain));
    program->addShader(
        new osg::Shader(osg::Shader::FRAGMENT, version + glslFragmentFunctions() + kFragmentMain));
    bindObjectAttributes(*program);
    return program;
}

void addObjectShading(osg::StateSet& state)
{
    state.setAttributeAndModes(makeObjectProgram());
    state.addUniform(new osg::Uniform("pmTexture", 0));
    if (!state.getTextureAttribute(0, osg::StateAttribute::TEXTURE))
        state.setTextureAttributeAndModes(0, whiteTexture());
}

} // namespace osgPMObjects
