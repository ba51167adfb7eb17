// SPDX-License-Identifier: Apache-2.0
// From triangle to triangle in a DiamondTree: what everything else spends its time with, and so is compiled into it.
#pragma once

#include <osgTerrainROAM/core/roam/DiamondTree.h>

namespace osgTerrainROAM::core
{

inline GridPoint DiamondTree::towardsMiddle(TriangleId t, int scale) const
{
    const DiamondPlace& apex = _places[t.apex()];
    const unsigned direction = (apex.direction + 2u * t.quadrant() + 1u) & 7u;
    const int height = (scale * _lastSample) >> ((apex.level + 3) >> 1);
    const GridPoint p = apex.point();
    return {4 * p.column + detail::kColumnStep[direction] * height,
            4 * p.row + detail::kRowStep[direction] * height};
}

inline GridPoint DiamondTree::middle(TriangleId t) const
{
    const GridPoint quarters = towardsMiddle(t, 4);
    return {quarters.column >> 2, quarters.row >> 2};
}

inline std::array<TriangleId, 2> DiamondTree::children(TriangleId t) const
{
    const VertexSlot v = splitVertex(t);
    const unsigned slot = _diamonds[v].parents[0] == t.apex() ? 0u : 2u;
    return {TriangleId(v, slot), TriangleId(v, detail::previous(slot))};
}

inline std::array<TriangleId, 2> DiamondTree::parents(VertexSlot v) const
{
    const Diamond& diamond = _diamonds[v];
    const DiamondPlace& place = _places[v];
    return {TriangleId(diamond.parents[0], place.firstQuadrant),
            diamond.parents[1] == kNone ? TriangleId()
                                        : TriangleId(diamond.parents[1], place.secondQuadrant)};
}

inline TriangleId DiamondTree::acrossBase(TriangleId t) const
{
    if (t.apex() < kCorners) return kRoots[t == kRoots[0] ? 1 : 0];
    // The base ends at one of the diamond's parents. What lies across hangs on that parent, too, one quadrant further.
    const unsigned slot = detail::parentOnEdge(t.quadrant());
    const VertexSlot parent = _diamonds[t.apex()].parents[slot / 2];
    const unsigned mine = _places[t.apex()].parentQuadrant(slot);
    const bool clockwise = t.quadrant() % 2 == 0;
    const TriangleId coarser(parent, clockwise ? detail::previous(mine) : detail::next(mine));
    const std::uint32_t there = link(coarser);
    if (there == kAbsent) return {};
    if (there < kSplit) return coarser;
    const VertexSlot v = there & ~kSplit;
    const unsigned back = _diamonds[v].parents[0] == parent ? 0u : 2u;
    return {v, clockwise ? detail::previous(back) : back};
}

inline std::uint32_t DiamondTree::regionOf(TriangleId t) const
{
    if (level(t) < _regionLevel) return 0;
    return 1 + tile().regions.pathAt(towardsMiddle(t, 2)); // half-way to the base: inside, on no border
}

} // namespace osgTerrainROAM::core
