// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osg/GraphicsContext>
#include <osgViewer/View>

#include "view/Channel.h"
#include "view/ScaledPicture.h"

namespace trainer
{

/// The cameras of all channels as slaves of a viewer. They share the eye point and so one terrain mesh. The
/// master camera draws nothing; it has the view matrix of the eye and the projection of the first channel.
/// Near and far planes are fixed by the setup, so an image does not depend on what else is visible.
/// Threads: the update phase of the viewer.
class ChannelRig
{
public:
    /// `contexts`: one for each of picturesOf(setup), of that size, in that order. Precondition: their
    /// number.
    ChannelRig(osgViewer::View& view, ViewSetup setup,
               const std::vector<osg::ref_ptr<osg::GraphicsContext>>& contexts);

    /// Sets the camera pose for the next frame.
    void setEye(const scenery::Pose& eye);

    /// Takes other sizes, frustums, near and far planes of the same channels, for a window that has changed.
    void reshape(ViewSetup setup);

    /// Draws a share of the pixels along each side, above 0; ScaledPicture shows them as the whole picture.
    /// Above 1 the contexts' framebuffers must be as much larger (osgOffscreen::FrameBuffer::drawnSide()).
    void setDrawnSide(double share);

    const ViewSetup& setup() const { return _setup; }
    const std::vector<osg::ref_ptr<osg::Camera>>& cameras() const { return _cameras; }

private:
    void shape();

    osg::ref_ptr<osg::Camera> _master;
    ViewSetup _setup;
    std::vector<osg::ref_ptr<osg::Camera>> _cameras;
    std::vector<ScaledPicture> _scaled; ///< one for each camera
    double _drawnSide = 1.0;
};

} // namespace trainer
