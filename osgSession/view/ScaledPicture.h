// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Camera>
#include <osg/Geometry>
#include <osgViewer/View>

namespace trainer
{

/// Where pixels of a picture lie in its framebuffer: drawn with fewer or more of them, and shown.
struct PicturePlace
{
    int leftPx = 0, drawnLeftPx = 0;
    int drawnWidthPx = 1, drawnHeightPx = 1;
    int widthPx = 1, heightPx = 1;
};

/// Draws other pixels than are shown. Fewer: the scene is drawn into the lower left part of the picture's
/// place, and that part is spread over all of the place, with bilinear weights, before what is drawn over it
/// (hud). Samples of a pixel are resolved first. More: the framebuffer is as much larger
/// (osgOffscreen::FrameBuffer::drawnSide()), and twice as many along each side become means of four.
/// Threads: the update phase of the viewer; the copy is made in draw. Errors: none; where a texture cannot be
/// drawn into, the part stays as it is.
class ScaledPicture
{
public:
    /// Adds a camera to the view that draws after `picture` into the same context.
    ScaledPicture(osgViewer::View& view, osg::Camera& picture);

    /// Sets the place for the next picture. Nothing is spread where all pixels are drawn.
    void fit(const PicturePlace& place);

private:
    osg::ref_ptr<osg::Camera> _camera;
    osg::ref_ptr<osg::Geometry> _part;
};

} // namespace trainer
