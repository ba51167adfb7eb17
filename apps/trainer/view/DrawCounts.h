// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Camera>
#include <osgUtil/RenderBin>

namespace trainer
{

/// Returns how many draws of OpenGL a render bin takes, those in it included: one of several ranges or instances is one. What is drawn before
/// it, as shadow maps are, does not count.
unsigned int drawsOf(osgUtil::RenderBin& bin);

/// Counts the draws of each picture of a camera of a viewer, as its initial draw callback. Threads: that which draws.
class DrawCounter : public osg::Camera::DrawCallback
{
public:
    void operator()(osg::RenderInfo& renderInfo) const override;

    unsigned int draws() const { return _draws; }

private:
    mutable unsigned int _draws = 0; ///< OSG calls it as if it were constant
};

} // namespace trainer
