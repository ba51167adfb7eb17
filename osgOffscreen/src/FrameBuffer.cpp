// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osg/FrameBufferObject>

#include <osgOffscreen/FrameBuffer>
#include <osgOffscreen/ProcessorDrawing>

namespace osgOffscreen
{

bool FrameBuffer::create(const osg::GLExtensions& gl, int widthPx, int heightPx, int samples,
                         Sampling sampling)
{
    if (!gl.isFrameBufferObjectSupported || !gl.glBlitFramebuffer || widthPx < 1 || heightPx < 1)
        return false;
    GLint largest = 0;
    GLint mostSamples = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE_EXT, &largest);
    glGetIntegerv(GL_MAX_SAMPLES_EXT, &mostSamples);
    if (widthPx > largest || heightPx > largest || samples < 0 || samples > mostSamples) return false;
    const GLubyte* const renderer = glGetString(GL_RENDERER);
    int side = sampling == Sampling::cheapest && renderer
                   ? pixelsInPlaceOf(samples, reinterpret_cast<const char*>(renderer))
                   : 1;
    if (std::max(widthPx, heightPx) > largest / side) side = 1;

    _widthPx = widthPx;
    _heightPx = heightPx;
    _drawnSide = side;
    _samples = samples > 1 && side == 1 ? samples : 0;
    const bool complete = createOne(gl, 0, _samples) && (_samples == 0 || createOne(gl, 1, 0));
    if (!complete) destroy(gl);
    return complete;
}

bool FrameBuffer::createOne(const osg::GLExtensions& gl, int index, int samples)
{
    GLuint* buffers = &_renderbuffers[static_cast<std::size_t>(index) * 2];
    gl.glGenFramebuffers(1, &_framebuffers[static_cast<std::size_t>(index)]);
    gl.glGenRenderbuffers(2, buffers);
    gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, _framebuffers[static_cast<std::size_t>(index)]);
    for (const int part : {0, 1})
    {
        gl.glBindRenderbuffer(GL_RENDERBUFFER_EXT, buffers[part]);
        gl.glRenderbufferStorageMultisample(GL_RENDERBUFFER_EXT, samples,
                                            part == 0 ? GL_RGBA8 : GL_DEPTH24_STENCIL8_EXT,
                                            _drawnSide * _widthPx, _drawnSide * _heightPx);
        gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER_EXT,
                                     part == 0 ? GL_COLOR_ATTACHMENT0_EXT : GL_DEPTH_STENCIL_ATTACHMENT,
                                     GL_RENDERBUFFER_EXT, buffers[part]);
    }
    gl.glBindRenderbuffer(GL_RENDERBUFFER_EXT, 0);
    return gl.glCheckFramebufferStatus(GL_FRAMEBUFFER_EXT) == GL_FRAMEBUFFER_COMPLETE_EXT;
}

void FrameBuffer::destroy(const osg::GLExtensions& gl)
{
    gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, 0);
    // Zero names, as of parts never made, are skipped by GL.
    gl.glDeleteFramebuffers(static_cast<GLsizei>(_framebuffers.size()), _framebuffers.data());
    gl.glDeleteRenderbuffers(static_cast<GLsizei>(_renderbuffers.size()), _renderbuffers.data());
    *this = FrameBuffer();
}

void FrameBuffer::bindForDrawing(const osg::GLExtensions& gl) const
{
    gl.glBindFramebuffer(GL_FRAMEBUFFER_EXT, _framebuffers[0]);
}

void FrameBuffer::bindForReading(const osg::GLExtensions& gl) const
{
    if (_samples == 0)
    {
        gl.glBindFramebuffer(GL_READ_FRAMEBUFFER_EXT, _framebuffers[0]);
        return;
    }
    // Scissoring would cut the resolve.
    const GLboolean scissored = glIsEnabled(GL_SCISSOR_TEST);
    glDisable(GL_SCISSOR_TEST);
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER_EXT, _framebuffers[0]);
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER_EXT, _framebuffers[1]);
    gl.glBlitFramebuffer(0, 0, _widthPx, _heightPx, 0, 0, _widthPx, _heightPx, GL_COLOR_BUFFER_BIT,
                         GL_NEAREST);
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER_EXT, _framebuffers[1]);
    gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER_EXT, _framebuffers[0]);
    if (scissored) glEnable(GL_SCISSOR_TEST);
}

} // namespace osgOffscreen
