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

/// Orders of the faces of one model: plain VIPM, tswap (*Cache-friendly view-independent progressive meshes*,
/// Graphicon 2003), ours, all drawn by ProgressiveDrawable; and each level as static geometry in a new cache-friendly
/// order.
std::vector<Contestant> contestantsOf(const osgPMObjects::core::Mesh& mesh,
                                      const osgPMObjects::core::CollapseSequence& sequence);

} // namespace objectbench
