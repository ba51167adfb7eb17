// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <osgTerrainROAM/core/roam/LeafArena.h>
#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// A node of the bintree: a right isosceles triangle, counter-clockwise (apex, left, right).
/// Neighbours are exact for leaves; for a split triangle `base` alone is (its diamond partner).
struct alignas(64) BinTriangle
{
    NodeIndex base = kNone;  ///< across left–right
    NodeIndex left = kNone;  ///< across apex–left
    NodeIndex right = kNone; ///< across right–apex
    NodeIndex parent = kNone;
    NodeIndex firstChild = kNone;    ///< the children are neighbours in the pool; kNone: a leaf
    std::uint32_t vertices[3];       ///< slots of apex, left, right
    SampleIndex splitSample = kNone; ///< middle of the base; kNone at the finest level
    SplitBound bound{};              ///< of that sample, kept here because the walk asks for nothing else
    std::uint16_t path = 0;          ///< which of the nodes of its level, down to the region level
    std::uint8_t level = 0;
    bool inData = true;     ///< overlaps the data; only such leaves are drawn
    bool freesApex = false; ///< of a pair, the first node: the vertex at its apex goes when the pair goes

    bool isLeaf() const { return firstChild == kNone; }
};
static_assert(sizeof(BinTriangle) == 64, "one cache line, and aligned to it");

/// The triangle bintree of one tile and the operations that keep its leaves a conforming mesh.
/// Invariant: isConforming() after every public operation. No operation allocates but to grow a pool.
/// Source: Duchaineau et al. 1997, §4 (split, forced split, merge of diamonds); paper 1, §5.2; spec 1 D.
class BinTriangleTree
{
public:
    explicit BinTriangleTree(std::shared_ptr<const RoamTile> tile);

    /// Splits leaf `t`, whatever has to split before it, and its base neighbour. Returns triangles split.
    /// Precondition: canSplit(t).
    std::uint32_t forceSplit(NodeIndex t);

    /// Merges the diamond of the split triangle `t`, whose four (at the border two) children are leaves.
    void merge(NodeIndex t);

    /// Merges the split triangle `t` back to a leaf, after everything that stands on its children, one diamond after the
    /// other. Returns triangles merged. What enhMerge() is measured against.
    std::uint32_t forceMerge(NodeIndex t);

    /// The paper's operation: makes the split triangle `t` a leaf in one step. Its subtree goes, its diamond partner's
    /// too, and so does, outwards, every triangle whose base has lost its middle. The same mesh as forceMerge() leaves.
    /// Returns triangles merged.
    /// Cost: the boundary of what goes, and its leaves where it is smaller than a region; nodes and vertices are
    /// dismantled when a later split needs them.
    /// Source: paper 1, §5.2 (enhMerge); terrain anchors, point 8.
    std::uint32_t enhMerge(NodeIndex t);

    bool canSplit(NodeIndex t) const { return _nodes[t].isLeaf() && _nodes[t].splitSample != kNone; }
    bool isMergeable(NodeIndex t) const;

    const BinTriangle& node(NodeIndex t) const { return _nodes[t]; }
    static constexpr NodeIndex kRoots[2] = {0, 1};
    std::uint32_t leafCount() const
    {
        return _leafCount;
    } ///< all leaves, those beyond the data's edge included

    SampleIndex sampleOf(std::uint32_t vertexSlot) const { return _sampleOfVertex[vertexSlot]; }
    std::span<const MeshVertex> vertices() const { return _vertices; }
    const LeafArena& leaves() const { return _leaves; }

    /// Arena region of a leaf: 0 for those coarser than a region, else 1 + path at the region level.
    std::uint32_t regionOf(const BinTriangle& t) const { return t.level < _regionLevel ? 0u : t.path + 1u; }

    const MeshChanges& changes() const { return _changes; }
    void clearChanges() { _changes.clear(); }

    /// Exhaustive: neighbours mutual and sharing whole edges, levels within one, areas adding up to the tile,
    /// no T-junction, slots and pools consistent. For tests: O(nodes log nodes).
    bool isConforming() const;

private:
    friend struct
        BinTriangleTreeMutator; ///< tests break the tree through it, to prove that isConforming() can fail

    NodeIndex takePair();
    std::uint32_t addVertex(SampleIndex sample);
    void completeNode(BinTriangle& t);
    void splitOne(NodeIndex t, std::uint32_t middle);
    void mergeOne(NodeIndex t);
    void replaceNeighbour(NodeIndex of, NodeIndex from, NodeIndex to);
    void insertLeaf(NodeIndex t);
    void eraseLeaf(NodeIndex t);
    std::uint32_t collapse(NodeIndex t); // EnhMerge.cpp, as all up to countUndismantled
    std::uint32_t releaseLeaves(NodeIndex t);
    void dismantleOne();
    void countUndismantled(std::size_t& pairs, std::size_t& vertices) const;
    bool overlapsData(const BinTriangle& t) const;

    std::shared_ptr<const RoamTile> _tile;
    int _regionLevel;
    std::vector<BinTriangle> _nodes;
    std::vector<NodeIndex> _freePairs;
    std::vector<NodeIndex> _deadPairs;  ///< cut off with everything below them, not yet taken apart
    std::vector<NodeIndex> _collapsing; ///< work list of enhMerge(), empty between operations
    std::vector<MeshVertex> _vertices;
    std::vector<SampleIndex> _sampleOfVertex;
    std::vector<std::uint32_t> _freeVertices;
    LeafArena _leaves;
    std::vector<std::uint32_t> _undrawnLeaves; ///< beyond the data's edge: their number in each region
    MeshChanges _changes;
    std::uint32_t _leafCount = 0;
};

} // namespace osgTerrainROAM::core
