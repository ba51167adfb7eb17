// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osg/GraphicsContext>
#include <osgViewer/View>

#include "view/Channel.h"

namespace trainer
{

/// The cameras of all channels, as slaves of a viewer whose scene they show. They share the eye and so, at the same
/// place, one terrain mesh. The master camera draws nothing itself; it carries the eye's view and the first
/// channel's projection. Near and far planes are fixed by the setup: a picture does not depend on what else is seen.
/// Threads: as the viewer's update phase.
class ChannelRig
{
public:
    /// `contexts`: one for each of picturesOf(setup), of that size, in that order. A broken contract: another number.
    ChannelRig(osgViewer::View& view, ViewSetup setup,
               const std::vector<osg::ref_ptr<osg::GraphicsContext>>& contexts);

    /// For the next frame.
    void setEye(const scenery::Pose& eye);

    const ViewSetup& setup() const { return _setup; }
    const std::vector<osg::ref_ptr<osg::Camera>>& cameras() const { return _cameras; }

private:
    osg::ref_ptr<osg::Camera> _master;
    ViewSetup _setup;
    std::vector<osg::ref_ptr<osg::Camera>> _cameras;
};

} // namespace trainer
