// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <osg/FrameStamp>
#include <osg/State>

#include <osgOffscreen/FrameGrabber>
#include <osgOffscreen/OffscreenContext>

namespace osgOffscreen
{

namespace
{

/// Converts RGBA to RGB. The transfer from GL is RGBA, the format of the image in memory, and so a plain
/// copy.
osg::ref_ptr<osg::Image> withoutAlpha(const unsigned char* rgba, int widthPx, int heightPx)
{
    osg::ref_ptr<osg::Image> picture = new osg::Image;
    picture->allocateImage(widthPx, heightPx, 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
    unsigned char* rgb = picture->data();
    const std::size_t pixels = static_cast<std::size_t>(widthPx) * static_cast<std::size_t>(heightPx);
    for (std::size_t i = 0; i < pixels; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            rgb[3 * i + c] = rgba[4 * i + c];
    return picture;
}

} // namespace

FrameGrabber::FrameGrabber(Receiver receiver, unsigned lag) : _receiver(std::move(receiver)), _lag(lag) {}

void FrameGrabber::swapBuffersImplementation(osg::GraphicsContext* context)
{
    const osg::GLExtensions& gl = *context->getState()->get<osg::GLExtensions>();
    startTransfer(context, gl);
    while (_pending.size() > _lag)
        finishOldest(gl);
    context->swapBuffersImplementation();
}

void FrameGrabber::startTransfer(osg::GraphicsContext* context, const osg::GLExtensions& gl)
{
    const osg::FrameStamp* stamp = context->getState()->getFrameStamp();
    if (!stamp) return; // nothing has been drawn yet
    _widthPx = context->getTraits()->width;
    _heightPx = context->getTraits()->height;
    Pending pending{0, stamp->getFrameNumber()};
    if (_free.empty())
        gl.glGenBuffers(1, &pending.buffer);
    else
    {
        pending.buffer = _free.back();
        _free.pop_back();
    }
    auto* offscreen = dynamic_cast<OffscreenContext*>(context);
    if (offscreen)
        offscreen->bindForReading();
    else
        glReadBuffer(context->getTraits()->doubleBuffer ? GL_BACK : GL_FRONT);

    const auto bytes = static_cast<GLsizeiptr>(_widthPx) * _heightPx * 4;
    gl.glBindBuffer(GL_PIXEL_PACK_BUFFER_ARB, pending.buffer);
    gl.glBufferData(GL_PIXEL_PACK_BUFFER_ARB, bytes, nullptr, GL_STREAM_READ_ARB);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, _widthPx, _heightPx, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl.glBindBuffer(GL_PIXEL_PACK_BUFFER_ARB, 0);
    if (offscreen) offscreen->bindForDrawing();
    _pending.push_back(pending);
}

void FrameGrabber::finishOldest(const osg::GLExtensions& gl)
{
    const Pending oldest = _pending.front();
    _pending.pop_front();
    GrabbedFrame frame;
    frame.number = oldest.number;
    gl.glBindBuffer(GL_PIXEL_PACK_BUFFER_ARB, oldest.buffer);
    if (const void* pixels = gl.glMapBuffer(GL_PIXEL_PACK_BUFFER_ARB, GL_READ_ONLY_ARB))
        frame.picture = withoutAlpha(static_cast<const unsigned char*>(pixels), _widthPx, _heightPx);
    gl.glUnmapBuffer(GL_PIXEL_PACK_BUFFER_ARB);
    gl.glBindBuffer(GL_PIXEL_PACK_BUFFER_ARB, 0);
    _free.push_back(oldest.buffer);
    _receiver(std::move(frame));
}

void FrameGrabber::drain(osg::GraphicsContext* context)
{
    // A single-threaded viewer may keep its context current between frames without checking it again.
    const bool wasCurrent = context->isCurrent();
    if (!wasCurrent && !context->makeCurrent()) return;
    const osg::GLExtensions& gl = *context->getState()->get<osg::GLExtensions>();
    while (!_pending.empty())
        finishOldest(gl);
    gl.glDeleteBuffers(static_cast<GLsizei>(_free.size()), _free.data());
    _free.clear();
    if (!wasCurrent) context->releaseContext();
}

} // namespace osgOffscreen
