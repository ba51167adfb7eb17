// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include <osgTerrainROAM/core/roam/DiamondLinks.h>
#include <osgTerrainROAM/core/roam/LeafArena.h>
#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/SplitBounds.h>

namespace osgTerrainROAM::core
{

/// The triangle bintree of one tile, and the operations that keep its leaves a conforming mesh.
/// DiamondLinks stores it; this class adds the bounds of the tile, the arena of the drawn leaves (16 B a
/// leaf), the displacements of morphing, and the record of what changed.
/// Invariant: isConforming() after every public operation. Operations allocate only to grow a pool.
/// Source: Duchaineau et al., *ROAMing Terrain*, 1997, section 4 (split, forced split, merge of diamonds);
/// *Methods of continuous level of detail for terrain* (Graphicon 2002), section 5.2 (enhMerge).
class DiamondTree : public DiamondLinks
{
public:
    explicit DiamondTree(SplitBounds bounds, LeafPlacement placement = LeafPlacement::inOrder);

    /// Splits leaf `t` and its base neighbour; splits first the coarser leaves that this needs. Returns the
    /// number of triangles split. Precondition: canSplit(t).
    std::uint32_t forceSplit(TriangleId t);

    /// Counts the triangles that forceSplit(t) would split.
    std::uint32_t splitsNeeded(TriangleId t) const;

    /// Tells whether forceSplit(t) leaves no more than `maxLeaves`.
    bool hasRoomToSplit(TriangleId t, std::uint32_t maxLeaves) const
    {
        const std::uint32_t mostNeeded =
            2u * static_cast<std::uint32_t>(level(t) + 1); // a chain of diamonds, one a level
        if (_leafCount <= maxLeaves && maxLeaves - _leafCount >= mostNeeded) return true;
        return _leafCount + splitsNeeded(t) <= maxLeaves;
    }

    /// Removes vertex `v`, whose quadrants are leaves: its diamond merges.
    void merge(VertexSlot v);

    /// Removes `v` after all its descendants, one diamond after the other. Returns the number of triangles
    /// merged. It is the reference that enhMerge() is measured against.
    std::uint32_t forceMerge(VertexSlot v);

    /// Makes both triangles that `v` has split leaves in one step (the paper's enhMerge). Removes their
    /// subtrees and, outwards, the subtree of every triangle whose base has lost its middle. Leaves the same
    /// mesh as forceMerge(). Returns the number of triangles merged. Cost: one visit per removed vertex. See
    /// docs/decisions/0009.
    std::uint32_t enhMerge(VertexSlot v);

    bool canSplit(TriangleId t) const { return isLeaf(t) && level(t) < _levels; }
    bool isMergeable(VertexSlot v) const;

    SplitBound bound(VertexSlot v) const { return _bounds.bound(_places[v].point()); }
    /// Of the vertex that splits `t`; precondition as middle().
    SplitBound bound(TriangleId t) const { return _bounds.bound(middle(t)); }

    /// Whether children(t) come in the reverse of the order in which the leaves of a region are kept. That
    /// order visits all leaves below one half before all below the other, the half with the right corner
    /// first on every other level. So the curve enters and leaves at the ends of the base, and each leaf
    /// shares an edge with the one before (Sierpinski's curve).
    bool isAgainstOrder(TriangleId t) const { return level(t) % 2 != 0; }

    /// What the mesh has at a point of the grid: a vertex, or the leaves that such a vertex would split.
    struct AtPlace
    {
        VertexSlot vertex = kNone;
        std::array<TriangleId, 2> leaves;
        std::size_t leafCount = 0;
    };
    AtPlace atPlace(GridPoint p) const; // DiamondTreePlaces.cpp

    /// Calls visit(vertex, leaf) for every vertex of the mesh in a rectangle of the grid, corners of the tile
    /// included, and for every leaf that touches it; the other argument is kNone, or a triangle that does not
    /// exist.
    void forEachIn(const GridRect& rect, const std::function<void(VertexSlot, TriangleId)>& visit) const;

    /// Records that an edit of the tile has moved a vertex.
    void noteMoved(VertexSlot v) { _changes.vertices.push_back(v); }
    void setBounds(SplitBounds bounds) { _bounds = std::move(bounds); }

    MeshVertex vertex(VertexSlot v) const;

    /// The position of a vertex's sample; displacement: from there to where it is drawn (Morph.h). Units:
    /// metres.
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

    /// Displace vertices; the changes record which have moved. After an operation every vertex has to be
    /// displaced anew.
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

    /// The arena region of a leaf: 0 for leaves coarser than a region, else 1 + path at the region level.
    std::uint32_t regionOf(TriangleId t) const
    {
        if (level(t) < _regionLevel) return 0;
        return 1 + tile().regions.pathAt(towardsMiddle(t, 2)); // half-way to the base: inside, on no border
    }

    /// From now on the changes record removed vertices, too (PatchPool).
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

    /// Checks exhaustively: links mutual, positions and levels right, neighbours sharing whole edges, areas
    /// adding up to the tile, no T-junction, pools consistent. For tests: O(n log n).
    bool isConforming() const;

private:
    friend struct
        DiamondTreeMutator; ///< tests damage the tree through it, to prove that isConforming() can fail

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
    int _levels;
    int _regionLevel;
    bool _dataFillsTile;
    bool _notesGone = false;
    std::vector<glm::vec3> _displacements; ///< empty: none
    std::vector<VertexSlot> _freeSlots;
    LeafArena _leaves;
    std::uint32_t _undrawnLeaves = 0; ///< those beyond the data's edge
    MeshChanges _changes;
    std::size_t _linked = 0; ///< slots among the changes that the leaves' links agree with
    std::uint32_t _leafCount = 0;
};

} // namespace osgTerrainROAM::core
