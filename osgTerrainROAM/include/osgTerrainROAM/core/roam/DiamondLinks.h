// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <osgTerrainROAM/core/roam/DiamondPlace.h>
#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

/// The links of a triangle bintree that is stored by its diamonds: from a triangle to its children, parents
/// and neighbours. A vertex in the middle of a base has split the two triangles on either side. The four
/// triangles around it (two at the border) are the quadrants of its diamond. Each quadrant is a leaf, or is
/// split by a vertex one level finer, which it shares with a quadrant of the neighbouring diamond. So 32 B a
/// vertex hold the whole bintree: positions, neighbours and corners follow from a few links. Corners of a
/// diamond, counter-clockwise: apex of one split triangle, its left, apex of the other, its right. Quadrant i
/// lies between corners i and i + 1.
/// The functions are inline: refinement spends most of its time in them. Only DiamondTree changes the links.
/// Source: Duchaineau et al., *ROAMing Terrain*, 1997, section 4 (diamonds of a triangle bintree). Differs:
/// the vertices with their diamonds are stored, not the triangles
/// (docs/decisions/0010-diamonds-instead-of-triangles.md).
class DiamondLinks
{
public:
    static constexpr TriangleId kRoots[2] = {TriangleId(0, 0), TriangleId(1, 0)};
    static constexpr VertexSlot kCorners = 4; ///< slots below are the corners of the tile

    bool exists(TriangleId t) const { return link(t) != kAbsent; }
    bool isLeaf(TriangleId t) const { return link(t) < kSplit; }
    int level(TriangleId t) const { return _places[t.apex()].level + 1; }

    /// The vertices of the mesh have the slots below vertexSlots() for which place(v).isFree() is false.
    std::uint32_t vertexSlots() const { return static_cast<std::uint32_t>(_places.size()); }
    const DiamondPlace& place(VertexSlot v) const { return _places[v]; }

    /// The corners of a triangle in the grid, and their vertices.
    GridTriangle gridTriangle(TriangleId t) const;
    LeafTriangle vertices(TriangleId t) const;

    /// The middle of the base, where `t` splits. Precondition: level(t) < tile levels.
    GridPoint middle(TriangleId t) const
    {
        const GridPoint quarters = towardsMiddle(t, 4);
        return {quarters.column >> 2, quarters.row >> 2};
    }

    /// The vertex that splits `t`. Precondition: !isLeaf(t).
    VertexSlot splitVertex(TriangleId t) const { return link(t) & ~kSplit; }

    /// The two halves of `t`: with the left corner, with the right. Precondition: !isLeaf(t).
    std::array<TriangleId, 2> children(TriangleId t) const
    {
        const VertexSlot v = splitVertex(t);
        const unsigned slot = _diamonds[v].parents[0] == t.apex() ? 0u : 2u;
        return {TriangleId(v, slot), TriangleId(v, detail::previous(slot))};
    }

    /// The triangles that vertex `v` has split; the second does not exist where `v` lies on the border.
    std::array<TriangleId, 2> parents(VertexSlot v) const
    {
        const Diamond& diamond = _diamonds[v];
        const DiamondPlace& place = _places[v];
        return {TriangleId(diamond.parents[0], place.firstQuadrant),
                diamond.parents[1] == kNone ? TriangleId()
                                            : TriangleId(diamond.parents[1], place.secondQuadrant)};
    }

    /// The ends of the base in whose middle a vertex lies.
    std::array<VertexSlot, 2> baseEnds(VertexSlot v) const { return {corner(v, 1), corner(v, 3)}; }

    /// The neighbour of a leaf across its base; none at the border. It has the same level (and, split or not,
    /// is the partner in the diamond) or is a coarser leaf.
    TriangleId acrossBase(TriangleId t) const
    {
        if (t.apex() < kCorners) return kRoots[t == kRoots[0] ? 1 : 0];
        // The base ends at one of the diamond's parents. The neighbour is at that parent, too, one quadrant
        // further.
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

    /// The leaf that shares the leg of a leaf to its left or right corner; none at the border.
    TriangleId acrossLeg(TriangleId t, bool right) const;

protected:
    /// The value of a quadrant's link, unless it is the arena slot of a drawn leaf.
    static constexpr std::uint32_t kSplit = 0x80000000u;   ///< bit: the rest is the vertex that splits it
    static constexpr std::uint32_t kUndrawn = 0x7fffffffu; ///< a leaf beyond the data's outline
    static constexpr std::uint32_t kAbsent = kNone;        ///< beyond the tile's edge

    struct Diamond
    {
        VertexSlot parents[2] = {kNone,
                                 kNone}; ///< corners 0 and 2: the apexes of the triangles that it split
        std::uint32_t links[4] = {kAbsent, kAbsent, kAbsent, kAbsent};
    };

    explicit DiamondLinks(int lastSample) : _lastSample(lastSample) {}

    std::uint32_t link(TriangleId t) const { return _diamonds[t.apex()].links[t.quadrant()]; }
    std::uint32_t& link(TriangleId t) { return _diamonds[t.apex()].links[t.quadrant()]; }
    VertexSlot corner(VertexSlot v, unsigned index) const;

    /// The point at `scale` / 4 of the way from the apex to the middle of the base. Units: quarters of
    /// samples.
    GridPoint towardsMiddle(TriangleId t, int scale) const
    {
        const DiamondPlace& apex = _places[t.apex()];
        const unsigned direction = (apex.direction + 2u * t.quadrant() + 1u) & 7u;
        const int height = (scale * _lastSample) >> ((apex.level + 3) >> 1);
        const GridPoint p = apex.point();
        return {4 * p.column + detail::kColumnStep[direction] * height,
                4 * p.row + detail::kRowStep[direction] * height};
    }

    int _lastSample;                   ///< of the tile along a side
    std::vector<DiamondPlace> _places; ///< apart from the links: the deferral wheel reads nothing else
    std::vector<Diamond> _diamonds;
};

} // namespace osgTerrainROAM::core
