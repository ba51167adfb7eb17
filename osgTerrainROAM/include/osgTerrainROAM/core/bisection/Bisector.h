// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

#include <osgTerrainROAM/core/bisection/CoarseMesh.h>

namespace osgTerrainROAM::core
{

/// A triangle of a bintree over a side of a coarse mesh. The root of a side has that side as its base and the
/// centre of the face as its apex. A split joins the apex with the middle of the base. Nodes are numbered as
/// in a heap: 1 is the root, 2n and 2n + 1 are the halves of n; 2n has the left leg of n as its base, 2n + 1
/// the right one.
struct Bisector
{
    std::uint32_t side = kNoSide, node = 0;

    bool exists() const { return node != 0; }
    int level() const { return std::bit_width(node) - 1; }
    Bisector parent() const { return {side, node >> 1}; }
    Bisector half(unsigned which) const { return {side, node << 1 | which}; }

    bool operator==(const Bisector&) const = default;
};

/// A triangle, and those of its level that share a side with it; those that are not there do not exist().
struct BisectorNeighbours
{
    Bisector self, left, right, base; ///< across the left leg, the right leg, the base

    /// Returns a half with its neighbours.
    BisectorNeighbours half(unsigned which) const
    {
        const auto halfOf = [](Bisector b, unsigned w) { return b.exists() ? b.half(w) : Bisector{}; };
        if (which == 0) return {self.half(0), self.half(1), halfOf(base, 1), halfOf(left, 1)};
        return {self.half(1), halfOf(base, 0), self.half(0), halfOf(right, 0)};
    }
};

/// Returns a triangle's neighbours of the same level. Cost: one step a level.
/// Source: Dupuy, *Concurrent binary trees (with application to longest edge bisection)*, 2020, section 4;
/// roots over half-edges after Benyoub & Dupuy, *Concurrent binary trees for large-scale game components*,
/// 2024.
inline BisectorNeighbours neighboursOf(const CoarseMesh& mesh, Bisector triangle)
{
    const std::uint32_t s = triangle.side, twin = mesh.twin(s);
    BisectorNeighbours at{{s, 1}, {mesh.previous(s), 1}, {mesh.next(s), 1}, {}};
    if (twin != kNoSide) at.base = {twin, 1};
    for (int bit = triangle.level(); bit-- > 0;)
        at = at.half(triangle.node >> bit & 1u);
    return at;
}

} // namespace osgTerrainROAM::core
