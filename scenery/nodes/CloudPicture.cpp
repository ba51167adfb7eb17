// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/CloudPicture.h"

#include <algorithm>
#include <array>

#include <osg/GLExtensions>
#include <osg/Viewport>

#include "scenery/nodes/NoBound.h"

namespace scenery
{

namespace
{

osg::ref_ptr<osg::Texture2D> makeTarget(int widthPx, int heightPx, GLint format, GLenum source, GLenum type,
                                        osg::Texture::FilterMode filter)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setTextureSize(widthPx, heightPx);
    texture->setInternalFormat(format);
    texture->setSourceFormat(source);
    texture->setSourceType(type);
    texture->setFilter(osg::Texture::MIN_FILTER, filter);
    texture->setFilter(osg::Texture::MAG_FILTER, filter);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

void fillPicture(osg::Geometry& rectangle)
{
    const osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
    for (const auto& [x, y] : {std::pair{-1.0F, -1.0F}, {1.0F, -1.0F}, {-1.0F, 1.0F}, {1.0F, 1.0F}})
        corners->push_back({x, y, 0.0F});
    rectangle.setVertexArray(corners);
    rectangle.addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, 4));
    rectangle.setUseDisplayList(false);
    rectangle.setUseVertexBufferObjects(true);
    rectangle.setCullingActive(false);
    rectangle.setComputeBoundingBoxCallback(new NoBound);
}

} // namespace

CloudPicture::Target& CloudPicture::targetFor(osg::State& state) const
{
    const osg::Viewport* const viewport = state.getCurrentViewport();
    const int width = std::max(1, (static_cast<int>(viewport->width()) + _pixelsPerRay - 1) / _pixelsPerRay);
    const int height =
        std::max(1, (static_cast<int>(viewport->height()) + _pixelsPerRay - 1) / _pixelsPerRay);
    Target& target = _targets[state.getContextID()][{width, height}];
    if (target.buffer) return target;
    target.widthPx = width;
    target.heightPx = height;
    target.colour = makeTarget(width, height, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, osg::Texture::LINEAR);
    target.away = makeTarget(width, height, GL_R32F, GL_RED, GL_FLOAT, osg::Texture::NEAREST);
    target.buffer = new osg::FrameBufferObject;
    target.buffer->setAttachment(osg::Camera::COLOR_BUFFER0, osg::FrameBufferAttachment(target.colour));
    target.buffer->setAttachment(osg::Camera::COLOR_BUFFER1, osg::FrameBufferAttachment(target.away));
    return target;
}

CloudRays::CloudRays(CloudPicture* picture) : _picture(picture)
{
    fillPicture(*this);
}

void CloudRays::drawImplementation(osg::RenderInfo& info) const
{
    osg::State& state = *info.getState();
    const osg::GLExtensions* const gl = state.get<osg::GLExtensions>();
    const CloudPicture::Target& target = _picture->targetFor(state);
    GLint drawnInto = 0;
    glGetIntegerv(GL_FRAMEBUFFER_BINDING_EXT, &drawnInto);
    // Textures that the buffer makes are bound to whatever unit is current: one that nobody here uses.
    state.setActiveTextureUnit(CloudSheet::kAwayUnit);
    target.buffer->apply(state);
    state.haveAppliedTextureAttribute(CloudSheet::kAwayUnit, osg::StateAttribute::TEXTURE);
    glViewport(0, 0, target.widthPx, target.heightPx);
    osg::Geometry::drawImplementation(info);
    gl->glBindFramebuffer(GL_FRAMEBUFFER_EXT, static_cast<GLuint>(drawnInto));
    state.getCurrentViewport()->apply(state);
}

CloudSheet::CloudSheet(CloudPicture* picture) : _picture(picture)
{
    fillPicture(*this);
}

void CloudSheet::drawImplementation(osg::RenderInfo& info) const
{
    osg::State& state = *info.getState();
    const CloudPicture::Target& target = _picture->targetFor(state);
    state.applyTextureAttribute(kColourUnit, target.colour);
    state.applyTextureAttribute(kAwayUnit, target.away);
    osg::Geometry::drawImplementation(info);
    state.haveAppliedTextureAttribute(kColourUnit, osg::StateAttribute::TEXTURE);
    state.haveAppliedTextureAttribute(kAwayUnit, osg::StateAttribute::TEXTURE);
}

} // namespace scenery
