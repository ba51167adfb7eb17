// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/NodeCallback>
#include <osgUtil/RenderStage>

namespace trainer
{

/// Returns how many draws of OpenGL a render bin takes, those in it included: one of several ranges or
/// instances is one. What is drawn before it, as shadow maps are, does not count.
unsigned int drawsOf(osgUtil::RenderBin& bin);

/// Returns how many draws the stages take that are drawn before a stage, as shadow maps are, with those
/// before them.
unsigned int drawsBefore(osgUtil::RenderStage& stage);

/// Counts the draws of each picture of a camera of a viewer, as its cull callback. Threads: that which culls.
class DrawCounter : public osg::NodeCallback
{
public:
    void operator()(osg::Node* node, osg::NodeVisitor* visitor) override;

    unsigned int draws() const { return _draws; }
    unsigned int drawsBefore() const { return _drawsBefore; }

private:
    unsigned int _draws = 0, _drawsBefore = 0;
};

} // namespace trainer
