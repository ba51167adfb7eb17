// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/tessellate/EdgeNoding.h>

namespace osgPMObjects::core
{

/// Which places belong to a polygon, by how often its contours run around them counter-clockwise, less clockwise.
enum class InsideRule
{
    odd,      ///< an odd number of times: whatever the direction of holes, and both halves of a bow-tie
    nonZero,  ///< any number of times: overlaps belong to it
    positive, ///< more often counter-clockwise
};

/// Points in a row around a part of the plane, which lies to the left of each edge: counter-clockwise around it, clockwise
/// around its holes. A point comes as often as the part has sectors there; sectors of visits to one point do not overlap.
using Loop = std::vector<std::uint32_t>;

/// The borders between inside and outside. Edges with the inside on both sides are dropped. Two loops of the same part of
/// the inside have no point in common.
/// Cost: n log n for edges around points, and a ray through all edges for each group of connected ones.
std::vector<Loop> insideLoops(const NodedEdges& noded, InsideRule rule);

} // namespace osgPMObjects::core
