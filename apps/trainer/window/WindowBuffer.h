// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgViewer/GraphicsWindow>

#include <osgOffscreen/FrameBuffer>

namespace trainer
{

/// Lets all cameras of a window draw into a framebuffer object, as those of an offscreen context do, and
/// copies each picture into the window before it is shown. Mesa's windows lie upside down in memory: drawn
/// straight into one, edges round to the other side, and a picture differs by some levels from the same one
/// offscreen. The swap callback that the window has when this begins is called after the copy.
/// Threads: the one that draws. Memory: the buffers live until release().
class WindowBuffer final : public osg::GraphicsContext::SwapCallback
{
public:
    /// Makes the buffers in the size of the window. Null: this OpenGL has none of that size or number of
    /// samples.
    static osg::ref_ptr<WindowBuffer> begin(osgViewer::GraphicsWindow& window, int samples);

    /// Follows the size of the window; between two pictures. False: as begin().
    bool fit();

    /// Gives the window its own memory and its old swap callback back. Needs a window that is open.
    void release();

    void swapBuffersImplementation(osg::GraphicsContext* context) override;

    const osgOffscreen::FrameBuffer& buffer() const { return _buffer; }

private:
    WindowBuffer(osgViewer::GraphicsWindow& window, int samples) : _window(&window), _samples(samples) {}

    osg::observer_ptr<osgViewer::GraphicsWindow> _window;
    osg::ref_ptr<osg::GraphicsContext::SwapCallback> _then;
    osgOffscreen::FrameBuffer _buffer;
    int _samples, _widthPx = 0, _heightPx = 0;
};

} // namespace trainer
