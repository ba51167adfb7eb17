// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Camera>

namespace objectbench
{

/// A camera's final callback: frames end with their pixels, which llvmpipe's threads would else paint in the time of the next.
struct Finish : osg::Camera::DrawCallback
{
    void operator()(osg::RenderInfo&) const override { glFinish(); }
};

} // namespace objectbench
