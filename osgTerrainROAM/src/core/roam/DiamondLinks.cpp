// SPDX-License-Identifier: Apache-2.0
#include <osgTerrainROAM/core/roam/DiamondLinks.h>

namespace osgTerrainROAM::core
{

GridTriangle DiamondLinks::gridTriangle(TriangleId t) const
{
    const DiamondPlace& apex = _places[t.apex()];
    const int leg = _lastSample >> ((apex.level + 2) / 2);
    const auto cornerAt = [&](unsigned index)
    {
        const unsigned direction = (apex.direction + 2u * index) & 7u;
        const GridPoint p = apex.point();
        return GridPoint{p.column + detail::kColumnStep[direction] * leg,
                         p.row + detail::kRowStep[direction] * leg};
    };
    return {apex.point(), cornerAt(t.quadrant()), cornerAt(t.quadrant() + 1u)};
}

/// Corners 1 and 3 are those of the first parent's quadrant that the vertex has split.
VertexSlot DiamondLinks::corner(VertexSlot v, unsigned index) const
{
    if (v < kCorners) return 2u + ((v + index) & 1u); // the roots' bases
    if (index % 2 == 0) return _diamonds[v].parents[index / 2];
    const unsigned quadrant = _places[v].firstQuadrant;
    return corner(_diamonds[v].parents[0], index == 1 ? quadrant : detail::next(quadrant));
}

LeafTriangle DiamondLinks::vertices(TriangleId t) const
{
    return {{t.apex(), corner(t.apex(), t.quadrant()), corner(t.apex(), detail::next(t.quadrant()))}};
}

TriangleId DiamondLinks::acrossLeg(TriangleId t, bool right) const
{
    const TriangleId beside(t.apex(), right ? detail::next(t.quadrant()) : detail::previous(t.quadrant()));
    if (!exists(beside)) return {};
    if (isLeaf(beside)) return beside;
    return children(beside)[right ? 0 : 1];
}

} // namespace osgTerrainROAM::core
