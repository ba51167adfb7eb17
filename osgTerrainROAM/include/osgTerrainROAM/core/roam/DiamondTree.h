// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <osgTerrainROAM/core/roam/GridTriangle.h>
#include <osgTerrainROAM/core/roam/LeafArena.h>
#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/SplitBounds.h>

namespace osgTerrainROAM::core
{

namespace detail
{

/// The eight directions, counter-clockwise from east.
inline constexpr int kColumnStep[8] = {1, 1, 0, -1, -1, -1, 0, 1};
inline constexpr int kRowStep[8] = {0, 1, 1, 1, 0, -1, -1, -1};

constexpr unsigned next(unsigned quadrant)
{
    return (quadrant + 1u) & 3u;
}

constexpr unsigned previous(unsigned quadrant)
{
    return (quadrant + 3u) & 3u;
}

/// Which of the corners 0 and 2, those that are parents, is an end of the outer edge of a quadrant.
constexpr unsigned parentOnEdge(unsigned quadrant)
{
    return (quadrant + 1u) & 2u;
}

} // namespace detail

/// Where a vertex lies in the grid and in the bintree.
struct DiamondPlace
{
    static constexpr unsigned kFree = 0x80;     ///< set in `direction`: no vertex has this slot
    static constexpr unsigned kLostBoth = 0x40; ///< besides: both of its parents went in the same enhMerge

    std::uint32_t column : 22 = 0;
    std::uint32_t firstQuadrant : 2 = 0; ///< of corner 0, which the vertex split
    std::int32_t level : 8 = -1;         ///< of the triangles that the vertex split; -1: a corner of the tile
    std::uint32_t row : 22 = 0;
    std::uint32_t secondQuadrant : 2 = 0; ///< of corner 2
    std::uint32_t direction : 8 =
        kFree; ///< of the diamond's first corner: 0 east, 1 north-east … 7 south-east

    bool isFree() const { return (direction & kFree) != 0; }
    GridPoint point() const { return {static_cast<int>(column), static_cast<int>(row)}; }

    /// Which quadrant of corner 0 or 2 it split.
    unsigned parentQuadrant(unsigned corner) const { return corner == 0 ? firstQuadrant : secondQuadrant; }
};
static_assert(sizeof(DiamondPlace) == 8);

/// The triangle bintree of one tile, kept by its diamonds, and the operations that keep its leaves a conforming mesh.
/// A vertex in the middle of a base has split the two triangles on either side, and the four (at the border two)
/// triangles around it are the quadrants of its diamond. Each quadrant is a leaf, or is split by a vertex one level
/// finer, which it shares with a quadrant of the diamond next to it. So 32 B a vertex, 16 B a leaf, hold the whole
/// bintree: places, neighbours and corners follow from a few links.
/// Corners of a diamond, counter-clockwise: apex of one split triangle, its left, apex of the other, its right. Quadrant
/// i lies between corners i and i + 1.
/// Invariant: isConforming() after every public operation. No operation allocates but to grow a pool.
/// Source: Duchaineau et al. 1997, §4 (split, forced split, merge of diamonds); paper 1, §5.2; spec 1 D;
/// docs/decisions/0010.
class DiamondTree
{
public:
    explicit DiamondTree(SplitBounds bounds, LeafPlacement placement = LeafPlacement::inOrder);

    /// Splits leaf `t`, whatever has to split before it, and its base neighbour. Returns triangles split.
    /// Precondition: canSplit(t).
    std::uint32_t forceSplit(TriangleId t);

    /// How many triangles forceSplit(t) would split.
    std::uint32_t splitsNeeded(TriangleId t) const;

    /// Whether forceSplit(t) leaves no more than `maxLeaves`.
    bool hasRoomToSplit(TriangleId t, std::uint32_t maxLeaves) const
    {
        const std::uint32_t mostNeeded =
            2u * static_cast<std::uint32_t>(level(t) + 1); // a chain of diamonds, one a level
        if (_leafCount <= maxLeaves && maxLeaves - _leafCount >= mostNeeded) return true;
        return _leafCount + splitsNeeded(t) <= maxLeaves;
    }

    /// Takes vertex `v`, whose quadrants are leaves, out again: its diamond merges.
    void merge(VertexSlot v);

    /// Takes out `v` after everything that stands on it, one diamond after the other. Returns triangles merged. What
    /// enhMerge() is measured against.
    std::uint32_t forceMerge(VertexSlot v);

    /// The paper's operation: both triangles that `v` has split become leaves in one step. Their subtrees go, and so
    /// does, outwards, that of every triangle whose base has lost its middle. The same mesh as forceMerge() leaves.
    /// Returns triangles merged. Cost: one visit per removed vertex. Source: paper 1, §5.2 (enhMerge); docs/decisions/0009.
    std::uint32_t enhMerge(VertexSlot v);

    static constexpr TriangleId kRoots[2] = {TriangleId(0, 0), TriangleId(1, 0)};
    static constexpr VertexSlot kCorners = 4; ///< slots below are the corners of the tile

    bool exists(TriangleId t) const { return link(t) != kAbsent; }
    bool isLeaf(TriangleId t) const { return link(t) < kSplit; }
    bool canSplit(TriangleId t) const { return isLeaf(t) && level(t) < _levels; }
    bool isMergeable(VertexSlot v) const;

    int level(TriangleId t) const { return _places[t.apex()].level + 1; }
    GridTriangle gridTriangle(TriangleId t) const;
    LeafTriangle vertices(TriangleId t) const;
    SplitBound bound(VertexSlot v) const { return _bounds.bound(_places[v].point()); }
    SplitBound bound(TriangleId t) const
    {
        return _bounds.bound(middle(t));
    } ///< of what splits it; as middle()
    GridPoint
    middle(TriangleId t) const; ///< of the base: where `t` splits. Precondition: level(t) < tile levels

    /// The vertex that splits `t`, and its two halves: with the left corner, with the right. Precondition: !isLeaf(t).
    VertexSlot splitVertex(TriangleId t) const { return link(t) & ~kSplit; }
    std::array<TriangleId, 2> children(TriangleId t) const;

    /// The order in which the leaves of a region are kept: all below the first half before all below the other, and the
    /// half with the right corner first on every other level. So the way goes in and out at the ends of the base, and
    /// each leaf shares an edge with the one before (Sierpinski's curve).
    bool isAgainstOrder(TriangleId t) const { return level(t) % 2 != 0; } ///< of children(t)

    /// The triangles that vertex `v` has split; the second does not exist where `v` lies on the border.
    std::array<TriangleId, 2> parents(VertexSlot v) const;

    /// Neighbours of a leaf: what shares its base, and the leaf that shares its leg to the left or right corner. None at
    /// the border. Across the base it is of the same level (and, split or not, its diamond partner) or a coarser leaf.
    TriangleId acrossBase(TriangleId t) const;
    TriangleId acrossLeg(TriangleId t, bool right) const;

    /// What of the mesh is at a place of the grid: a vertex that it has, or the leaves that such a vertex would split.
    struct AtPlace
    {
        VertexSlot vertex = kNone;
        std::array<TriangleId, 2> leaves;
        std::size_t leafCount = 0;
    };
    AtPlace atPlace(GridPoint p) const; // DiamondTreePlaces.cpp

    /// Calls visit(vertex, leaf) for every vertex of the mesh in a rectangle of the grid, corners of the tile included, and
    /// for every leaf that touches it; the other is kNone, or does not exist.
    void forEachIn(const GridRect& rect, const std::function<void(VertexSlot, TriangleId)>& visit) const;

    /// The tile has been edited: a vertex lies elsewhere.
    void noteMoved(VertexSlot v) { _changes.vertices.push_back(v); }
    void setBounds(SplitBounds bounds) { _bounds = std::move(bounds); }

    /// Vertices: slots up to vertexSlots(), those that place(v).isFree() left out.
    std::uint32_t vertexSlots() const { return static_cast<std::uint32_t>(_places.size()); }
    const DiamondPlace& place(VertexSlot v) const { return _places[v]; }
    MeshVertex vertex(VertexSlot v) const;

    /// Where a vertex's sample lies, and how far from there it is drawn (Morph.h). Units: metres.
    glm::dvec3 samplePosition(VertexSlot v) const
    {
        const GridPoint p = _places[v].point();
        return tile().tile.position(p.column, p.row);
    }
    glm::vec3 displacement(VertexSlot v) const
    {
        return v < _displacements.size() ? _displacements[v] : glm::vec3(0.0f);
    }
    glm::dvec3 position(VertexSlot v) const { return samplePosition(v) + glm::dvec3(displacement(v)); }

    /// Ends of the base that a vertex lies in the middle of.
    std::array<VertexSlot, 2> baseEnds(VertexSlot v) const { return {corner(v, 1), corner(v, 3)}; }

    /// Displaces vertices; the changes say which have moved. Every vertex is to be displaced after an operation.
    void startDisplacing() { _displacements.resize(_places.size()); }
    void displace(VertexSlot v, const glm::vec3& metres)
    {
        if (_displacements[v] == metres) return;
        _displacements[v] = metres;
        _changes.vertices.push_back(v);
    }
    void stopDisplacing();

    const LeafArena& leaves() const { return _leaves; }
    std::uint32_t leafCount() const { return _leafCount; } ///< those beyond the data's edge included

    /// Arena region of a leaf: 0 for those coarser than a region, else 1 + path at the region level.
    std::uint32_t regionOf(TriangleId t) const;

    /// From now on the changes say which vertices have gone (PatchPool).
    void noteGone() { _notesGone = true; }

    const MeshChanges& changes() const { return _changes; }
    void clearChanges()
    {
        _changes.clear();
        _linked = 0;
    }

    const RoamTile& tile() const { return _bounds.tile(); }
    const SplitBounds& bounds() const { return _bounds; }
    std::size_t memoryBytes() const;

    /// Exhaustive: links mutual, places and levels right, neighbours sharing whole edges, areas adding up to the tile, no
    /// T-junction, pools consistent. For tests: O(n log n).
    bool isConforming() const;

private:
    friend struct
        DiamondTreeMutator; ///< tests break the tree through it, to prove that isConforming() can fail

    /// What a quadrant's link says besides the arena slot of a drawn leaf.
    static constexpr std::uint32_t kSplit = 0x80000000u;   ///< set: the rest is the vertex that splits it
    static constexpr std::uint32_t kUndrawn = 0x7fffffffu; ///< a leaf beyond the data's outline
    static constexpr std::uint32_t kAbsent = kNone;        ///< beyond the tile's edge

    struct Diamond
    {
        VertexSlot parents[2] = {kNone, kNone}; ///< corners 0 and 2: the apexes of what the vertex has split
        std::uint32_t links[4] = {kAbsent, kAbsent, kAbsent, kAbsent};
    };

    std::uint32_t link(TriangleId t) const { return _diamonds[t.apex()].links[t.quadrant()]; }
    std::uint32_t& link(TriangleId t) { return _diamonds[t.apex()].links[t.quadrant()]; }
    VertexSlot corner(VertexSlot v, unsigned index) const;
    /// From the apex towards the middle of the base, as far as that times `scale` / 4. Units: quarters of samples.
    GridPoint towardsMiddle(TriangleId t, int scale) const;
    VertexSlot takeSlot();
    VertexSlot addVertex(TriangleId t, TriangleId partner);
    void removeVertex(VertexSlot v);
    void splitLeaf(TriangleId t, VertexSlot v);
    void mergeLeaves(TriangleId t);
    void inherit(std::uint32_t slot, TriangleId t);
    std::uint32_t cutBelow(TriangleId t) const; // EnhMerge.cpp
    void addLeaf(TriangleId t);
    void removeLeaf(std::uint32_t slot);
    void relink();
    bool isDrawn(TriangleId t) const;
    std::uint32_t takeApart(VertexSlot v);  // EnhMerge.cpp
    bool linksAreSound(VertexSlot v) const; // DiamondTreeCheck.cpp

    SplitBounds _bounds;
    int _lastSample; ///< of the tile along a side
    int _levels;
    int _regionLevel;
    bool _dataFillsTile;
    bool _notesGone = false;
    std::vector<DiamondPlace> _places; ///< apart from the links: the deferral wheel reads nothing else
    std::vector<Diamond> _diamonds;
    std::vector<glm::vec3> _displacements; ///< empty: none
    std::vector<VertexSlot> _freeSlots;
    LeafArena _leaves;
    std::uint32_t _undrawnLeaves = 0; ///< those beyond the data's edge
    MeshChanges _changes;
    std::size_t _linked = 0; ///< slots among the changes that the leaves' links agree with
    std::uint32_t _leafCount = 0;
};

} // namespace osgTerrainROAM::core

#include <osgTerrainROAM/core/roam/DiamondTreeWays.h>
