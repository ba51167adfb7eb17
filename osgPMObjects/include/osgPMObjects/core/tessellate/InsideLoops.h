// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/tessellate/EdgeNoding.h>

namespace osgPMObjects::core
{

/// The rule that decides which points are inside a polygon, by its winding number: how often the contours run
/// around the point counter-clockwise, minus clockwise.
enum class InsideRule
{
    odd,      ///< odd numbers: holes may have any direction; both halves of a bow-tie are inside
    nonZero,  ///< all numbers but 0: overlaps are inside
    positive, ///< numbers above 0
};

/// A closed border of a part of the plane, as point numbers; the part lies to the left of each edge, so a
/// loop runs counter-clockwise around the part and clockwise around its holes. A point appears once for each
/// sector that the part has there; the sectors of two visits of one point do not overlap.
using Loop = std::vector<std::uint32_t>;

/// Returns the borders between inside and outside, without edges that have the inside on both sides. Two
/// loops of the same part of the inside have no common point.
/// Cost: n log n for sorting edges around points, and a ray through all edges for each group of connected
/// edges.
std::vector<Loop> insideLoops(const NodedEdges& noded, InsideRule rule);

} // namespace osgPMObjects::core
