// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <viewlod/Budget.h>
#include <viewlod/Sight.h>
#include <viewlod/Slice.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/DiamondTree.h>
#include <osgTerrainROAM/core/roam/Horizon.h>
#include <osgTerrainROAM/core/roam/Morph.h>
#include <osgTerrainROAM/core/roam/PatchPool.h>
#include <osgTerrainROAM/core/roam/QueueDriver.h>
#include <osgTerrainROAM/core/roam/RefineResult.h>
#include <osgTerrainROAM/core/roam/TerrainMesh.h>
#include <osgTerrainROAM/core/roam/WheelDriver.h>

namespace osgTerrainROAM::core
{

/// The triangulation of one terrain tile for one view group: it follows the eye from frame to frame.
/// A vertex is *active* exactly when its priority exceeds the tolerance (ActiveForEye). Priorities nest, so
/// the active vertices form a conforming mesh, the same for a given eye whatever came before. Three drivers
/// adapt it (Driver), all with this predicate and to the same mesh. The tile may be edited between
/// refinements (TileEditor); the next refinement follows.
/// Invariant: isConforming() after every operation. Threads: one at a time; if the tile is edited, with a
/// shared lock of its mutex. Memory: memoryBytes(), about 30 B per triangle; splits allocate only to grow a
/// pool.
/// Source: *Methods of continuous level of detail for terrain* (Graphicon 2002), section 5 (ROAM and its
/// frame loop).
class RoamMesh final : public TerrainMesh
{
public:
    /// `bounds`: a tile, or the SplitBounds of one with patches.
    explicit RoamMesh(SplitBounds bounds, Driver driver = Driver::wheel,
                      LeafPlacement placement = LeafPlacement::inOrder);

    /// Takes effect with the next refinement.
    void setDriver(Driver driver);
    Driver driver() const { return _driver; }

    /// Adapts to an eye. Errors are bounded in the whole frame (ViewState::guaranteedPixelsPerTangent).
    /// The triangle ceiling holds for the whole frame: τ rises until the mesh fits, and then follows the
    /// number of leaves, so that they stay within 1 % (or 4) below the ceiling. (TriangleCeiling.h finds τ
    /// anew when it has to change much; the queue driver merges the leaves of least priority.) Patches count
    /// with all their triangles; two triangles are always drawn. A lowered ceiling is met as soon as the time
    /// slices allow. When the time slice ends, the work stops; the next call continues: the wheel and the
    /// queues with the remaining work, the walk from the start. Frame of `view`: the tile's local frame.
    /// Cost: see the drivers.
    RefineResult refine(const viewlod::ViewState& view, const viewlod::Budget& budget) override;

    /// Refines only what is in sight from the next refinement for an eye on; errors are bounded there, and no
    /// horizon is known. The wheel checks all that is active in each frame in which the eye or the sight
    /// moves.
    void setSight(const viewlod::Sight& sight) override;

    /// Morphing: from the next refinement for an eye, vertices appear and disappear without a jump, and the
    /// error target holds for the drawn surface; the mesh is refined to two thirds of it (Morph). Patches do
    /// not morph: with them it stays off.
    void setMorphing(bool on) override { _isMorphing = on && !patches(); }
    bool isMorphing() const { return _isMorphing; }

    /// Refines for no eye in particular: a vertex is active exactly when e_v > errorM.
    RefineResult refine(double errorM) override;

    /// Whether the tile has been edited since the last refinement.
    bool isBehind() const override { return _revision != tile().revision(); }

    /// The data for the graphics card by slot, and the changes of the last refinement. Unused slots have any
    /// content.
    std::uint32_t vertexSlots() const override { return _tree.vertexSlots(); }
    std::uint32_t triangleSlots() const override { return _tree.leaves().slotCount(); }
    MeshVertex vertex(VertexSlot v) const { return _tree.place(v).isFree() ? MeshVertex{} : _tree.vertex(v); }
    LeafTriangle triangle(std::uint32_t slot) const
    {
        const TriangleId leaf = _tree.leaves().leaf(slot);
        return leaf.exists() ? _tree.vertices(leaf) : LeafTriangle{};
    }
    void appendVertices(IndexRange slots, std::vector<MeshVertex>& vertices) const override;
    void appendTriangles(IndexRange slots, std::vector<LeafTriangle>& triangles) const override;
    const MeshChanges& changes() const override { return _tree.changes(); }

    /// The patches, which are drawn instead of the leaves and have slots of their own; null: the leaves carry
    /// none.
    const PatchPool* patches() const override { return _patches ? &*_patches : nullptr; }
    void appendPatch(std::uint32_t slot, std::vector<MeshVertex>& vertices) const override;
    int patchExponent() const { return _tree.bounds().patchExponent(); }

    /// Appends the ranges of slots (of triangles or of patches) that may be visible to `ranges`:
    /// conservative, by regions of the tree (RegionBounds), then patch by patch. Only these ranges hold live
    /// slots; they also hold gaps, triangles without extent. Returns the number of triangles in them, gaps
    /// not counted.
    std::uint32_t visibleRanges(const viewlod::Frustum& frustum,
                                std::vector<IndexRange>& ranges) const override;

    /// Does the same, near ranges first, so that the depth test saves hidden fragments: about half of them in
    /// hills. With a horizon it omits ranges that are wholly below it.
    std::uint32_t visibleRanges(const viewlod::Frustum& frustum, const glm::dvec3& eye,
                                const Horizon* horizon, std::vector<IndexRange>& ranges) const override;

    /// The horizon for a camera at the eye that the mesh was last refined for. None for any other eye, and
    /// where it is not certain.
    std::optional<Horizon> horizon(const glm::dvec3& eye) const override;

    DrawnMesh drawn(std::span<const IndexRange> ranges) const override;
    using TerrainMesh::drawn;

    double nearestM(const glm::dvec3& point) const override;
    void forEachTriangleAtBorder(const BorderVisit& visit) const override;

    const DiamondTree& tree() const { return _tree; }
    const RoamTile& tile() const override { return _tree.tile(); }
    bool isValid() const override { return isConforming(); }
    bool isConforming() const { return _tree.isConforming(); }
    std::size_t memoryBytes() const override
    {
        return _tree.memoryBytes() + _wheel.memoryBytes() + _queues.memoryBytes() +
               (_patches ? _patches->memoryBytes() : 0);
    }

private:
    RefineResult adapt(const viewlod::ViewState& view, const viewlod::Budget& budget);
    RefineResult adaptAndMorph(const viewlod::ViewState& view, const viewlod::Budget& budget);
    std::uint32_t appendRanges(const std::vector<std::uint32_t>& regions, const viewlod::Frustum& frustum,
                               std::vector<IndexRange>& ranges) const;
    std::uint32_t appendPatches(std::uint32_t region, const viewlod::Frustum& frustum,
                                std::vector<IndexRange>& ranges) const;
    void recheck(GridPoint p);
    void followTile();
    void followMoved(const GridRect& rect);
    void followAll();
    void rewritePatches();
    bool run(const viewlod::ViewState& view, double tolerancePx, std::uint32_t maxLeaves,
             viewlod::Slice& slice, RefineResult& result);
    bool runWithinCeiling(const viewlod::ViewState& view, const viewlod::Budget& budget,
                          viewlod::Slice& slice, RefineResult& result);
    void finish(RefineResult& result);

    Driver _driver;
    DiamondTree _tree;
    WheelDriver _wheel;
    QueueDriver _queues;
    viewlod::Sight _sight;
    std::optional<PatchPool> _patches;
    Morph _morph;
    std::uint64_t _revision = 0;  ///< revision of the tile that the mesh shows
    std::vector<GridRect> _moved; ///< rectangles in which vertices of patches may have moved
    bool _isMorphing = false;
    bool _ceilingBound = false; ///< in the last frame
    double _lastTolerancePx = 0.0;
    std::optional<glm::dvec3> _eye; ///< last refined for
    double _errorPerM = 0.0;        ///< error of the drawn surface per distance from that eye, at most
    double _nearM = 0.0;
};

} // namespace osgTerrainROAM::core
