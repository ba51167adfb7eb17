// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Camera>

namespace objectbench
{

/// A final draw callback that waits until the frame is complete; otherwise the threads of llvmpipe would
/// paint it during the next frame.
struct Finish : osg::Camera::DrawCallback
{
    void operator()(osg::RenderInfo&) const override { glFinish(); }
};

} // namespace objectbench
