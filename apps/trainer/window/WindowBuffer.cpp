// SPDX-License-Identifier: Apache-2.0
#include "window/WindowBuffer.h"

#include <osg/FrameBufferObject>
#include <osg/State>

namespace trainer
{

namespace
{

const osg::GLExtensions& glOf(osg::GraphicsContext& context)
{
    return *osg::GLExtensions::Get(context.getState()->getContextID(), true);
}

} // namespace

osg::ref_ptr<WindowBuffer> WindowBuffer::begin(osgViewer::GraphicsWindow& window, int samples)
{
    osg::ref_ptr<WindowBuffer> made(new WindowBuffer(window, samples));
    if (!made->fit()) return nullptr;
    made->_then = window.getSwapCallback();
    window.setSwapCallback(made);
    return made;
}

bool WindowBuffer::fit()
{
    const osg::GraphicsContext::Traits& traits = *_window->getTraits();
    if (traits.width == _widthPx && traits.height == _heightPx) return true;
    // A viewer of one thread keeps its context current between pictures without asking again.
    const bool wasCurrent = _window->isCurrent();
    if (!wasCurrent && !_window->makeCurrent()) return false;
    const osg::GLExtensions& gl = glOf(*_window);
    _buffer.destroy(gl);
    _widthPx = traits.width;
    _heightPx = traits.height;
    const bool isMade =
        _buffer.create(gl, _widthPx, _heightPx, _samples, osgOffscreen::FrameBuffer::Sampling::cheapest);
    if (isMade) _buffer.bindForDrawing(gl);
    _window->setDefaultFboId(_buffer.drawId());
    if (!wasCurrent) _window->releaseContext();
    return isMade;
}

void WindowBuffer::release()
{
    _window->setSwapCallback(_then);
    _window->setDefaultFboId(0);
    const bool wasCurrent = _window->isCurrent();
    if (!wasCurrent && !_window->makeCurrent()) return;
    _buffer.destroy(glOf(*_window));
    if (!wasCurrent) _window->releaseContext();
}

void WindowBuffer::swapBuffersImplementation(osg::GraphicsContext* context)
{
    const osg::GLExtensions& gl = glOf(*context);
    _buffer.bindForReading(gl);
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER_EXT, 0);
    const GLboolean isScissored = glIsEnabled(GL_SCISSOR_TEST); // it would cut the copy
    glDisable(GL_SCISSOR_TEST);
    gl.glBlitFramebuffer(0, 0, _widthPx, _heightPx, 0, 0, _widthPx, _heightPx, GL_COLOR_BUFFER_BIT,
                         GL_NEAREST);
    if (isScissored) glEnable(GL_SCISSOR_TEST);
    gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, 0);
    if (_then)
        _then->swapBuffersImplementation(context);
    else
        context->swapBuffersImplementation();
    _buffer.bindForDrawing(gl);
}

} // namespace trainer
