// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <osg/Node>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

namespace objectbench
{

/// A way to draw a level.
struct Contestant
{
    std::string name;
    std::function<osg::ref_ptr<osg::Node>(std::uint32_t steps)> nodeAt;
};

/// Orders of one model's faces: plain VIPM, the paper's tswap, ours, all by ProgressiveDrawable; and plain geometry of each level, in
/// the order that serves a cache best, made from scratch.
std::vector<Contestant> contestantsOf(const osgPMObjects::core::Mesh& mesh,
                                      const osgPMObjects::core::CollapseSequence& sequence);

} // namespace objectbench
