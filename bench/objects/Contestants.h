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
/// Graphicon 2003), ours, all drawn by ProgressiveDrawable; and each level as static geometry in a new
/// cache-friendly order.
std::vector<Contestant> contestantsOf(const osgPMObjects::core::Mesh& mesh,
                                      const osgPMObjects::core::CollapseSequence& sequence);

/// Each level as static geometry: triangles in meshoptimizer's order and along Hilbert's curve, and one strip
/// for each material (joinStrips()), after SGI and of the dual graph.
std::vector<Contestant> stripContestantsOf(const osgPMObjects::core::Mesh& mesh,
                                           const osgPMObjects::core::CollapseSequence& sequence);

/// Those that can follow a moving level: plain VIPM, tswap with several numbers of orderings between all
/// faces and none, ours.
std::vector<Contestant> movingContestantsOf(const osgPMObjects::core::Mesh& mesh,
                                            const osgPMObjects::core::CollapseSequence& sequence);

} // namespace objectbench
