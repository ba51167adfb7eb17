// SPDX-License-Identifier: Apache-2.0
#include "view/ScaledPicture.h"

#include <osg/Depth>
#include <osg/FrameBufferObject>
#include <osg/GLExtensions>
#include <osg/Geode>
#include <osg/Program>
#include <osg/Texture2D>

namespace trainer
{

namespace
{

constexpr int kAfterInside = 6; ///< of what is drawn after the picture; before what is drawn over it (hud)

constexpr const char* kVertexText = R"(#version 330 compatibility
out vec2 at;
void main()
{
    at = 0.5 + 0.5 * gl_Vertex.xy;
    gl_Position = vec4(gl_Vertex.xy, 0.0, 1.0);
}
)";

constexpr const char* kFragmentText = R"(#version 330 compatibility
in vec2 at;
uniform sampler2D drawn;
uniform bool isTwice; // as many pixels are drawn along each side
void main()
{
    vec3 mean;
    if (isTwice)
    {
        ivec2 first = 2 * ivec2(at * vec2(textureSize(drawn, 0) / 2));
        mean = 0.25 * (texelFetch(drawn, first, 0).rgb + texelFetch(drawn, first + ivec2(1, 0), 0).rgb
                       + texelFetch(drawn, first + ivec2(0, 1), 0).rgb + texelFetch(drawn, first + ivec2(1, 1), 0).rgb);
    }
    else
        mean = texture(drawn, at).rgb;
    gl_FragColor = vec4(mean, 1.0);
}
)";

osg::ref_ptr<osg::Texture2D> pictureOf(const PicturePlace& place)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setTextureSize(place.drawnWidthPx, place.drawnHeightPx);
    texture->setInternalFormat(GL_RGBA8);
    texture->setResizeNonPowerOfTwoHint(false);
    for (const auto wrap : {osg::Texture::WRAP_S, osg::Texture::WRAP_T})
        texture->setWrap(wrap, osg::Texture::CLAMP_TO_EDGE);
    for (const auto filter : {osg::Texture::MIN_FILTER, osg::Texture::MAG_FILTER})
        texture->setFilter(filter, osg::Texture::LINEAR);
    return texture;
}

/// Copies the part that was drawn into a texture, then draws the rectangle that shows it.
class SpreadPart : public osg::Geometry
{
public:
    SpreadPart()
    {
        osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
        for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {-1.0F, 1.0F}, {1.0F, 1.0F}})
            corners->push_back({x, y, 0.0F});
        setVertexArray(corners);
        addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, 4));
        setUseDisplayList(false);
        setUseVertexBufferObjects(true);
        setCullingActive(false);
        osg::StateSet& state = *getOrCreateStateSet();
        const osg::ref_ptr<osg::Program> program = new osg::Program;
        program->addShader(new osg::Shader(osg::Shader::VERTEX, kVertexText));
        program->addShader(new osg::Shader(osg::Shader::FRAGMENT, kFragmentText));
        state.setAttributeAndModes(program);
        state.addUniform(new osg::Uniform("drawn", 0));
        state.setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0.0, 1.0, false));
        fit(_place);
    }

    void fit(const PicturePlace& place)
    {
        _place = place;
        const osg::ref_ptr<osg::Texture2D> texture = pictureOf(place);
        getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
        const bool isTwice =
            place.drawnWidthPx == 2 * place.widthPx && place.drawnHeightPx == 2 * place.heightPx;
        getOrCreateStateSet()->getOrCreateUniform("isTwice", osg::Uniform::BOOL)->set(isTwice);
        _copy = new osg::FrameBufferObject;
        _copy->setAttachment(osg::Camera::COLOR_BUFFER, osg::FrameBufferAttachment(texture));
    }

    void drawImplementation(osg::RenderInfo& renderInfo) const override
    {
        copy(*renderInfo.getState());
        osg::Geometry::drawImplementation(renderInfo);
    }

    void releaseGLObjects(osg::State* state) const override
    {
        osg::Geometry::releaseGLObjects(state);
        _copy->releaseGLObjects(state);
    }

private:
    void copy(osg::State& state) const
    {
        const osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
        GLint picture = 0;
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &picture);
        _copy->apply(state, osg::FrameBufferObject::DRAW_FRAMEBUFFER);
        gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(picture));
        const int right = _place.drawnWidthPx, up = _place.drawnHeightPx;
        gl.glBlitFramebuffer(_place.drawnLeftPx, 0, _place.drawnLeftPx + right, up, 0, 0, right, up,
                             GL_COLOR_BUFFER_BIT, GL_NEAREST);
        gl.glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(picture));
    }

    PicturePlace _place;
    osg::ref_ptr<osg::FrameBufferObject> _copy;
};

} // namespace

ScaledPicture::ScaledPicture(osgViewer::View& view, osg::Camera& picture)
    : _camera(new osg::Camera), _part(new SpreadPart)
{
    _camera->setName("scaled picture");
    _camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    _camera->setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
    _camera->setProjectionResizePolicy(osg::Camera::FIXED);
    _camera->setAllowEventFocus(false);
    _camera->setRenderOrder(osg::Camera::POST_RENDER, kAfterInside);
    _camera->setClearMask(0);
    _camera->setNodeMask(0);
    _camera->setGraphicsContext(picture.getGraphicsContext());
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(_part);
    _camera->addChild(geode);
    view.addSlave(_camera, false);
}

void ScaledPicture::fit(const PicturePlace& place)
{
    const bool isWhole = place.drawnWidthPx == place.widthPx && place.drawnHeightPx == place.heightPx;
    _camera->setNodeMask(isWhole ? 0U : ~0U);
    if (isWhole) return;
    _camera->setViewport(place.leftPx, 0, place.widthPx, place.heightPx);
    static_cast<SpreadPart&>(*_part).fit(place);
}

} // namespace trainer
