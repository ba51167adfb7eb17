// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <viewlod/Budget.h>
#include <viewlod/Slice.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/DiamondTree.h>
#include <osgTerrainROAM/core/roam/Horizon.h>
#include <osgTerrainROAM/core/roam/Morph.h>
#include <osgTerrainROAM/core/roam/PatchPool.h>
#include <osgTerrainROAM/core/roam/RefineResult.h>
#include <osgTerrainROAM/core/roam/WheelDriver.h>

namespace osgTerrainROAM::core
{

/// The triangulation of one terrain tile for one view group: it follows the eye from frame to frame.
/// A vertex is *active* exactly when K·e_v / max(|eye − X_v| − r_v, n) > τ; this nests, so the active set is a
/// conforming mesh, the same for a given eye whatever came before.
/// Three drivers take it there (Driver), all with this predicate and to the same mesh.
/// The tile may be edited between refinements (TileEditor); the next one follows.
/// Invariant: isConforming() after every operation. Threads: one at a time, holding a shared lock of the tile's mutex where
/// that is edited.
/// Memory: memoryBytes(), about 30 B per triangle; pools grow, and no split allocates otherwise.
/// Source: "Methods of continuous level of detail for terrain" (2002), §5; spec 1 D.
class RoamMesh
{
public:
    /// `bounds`: a tile, or what SplitBounds makes of it for patches.
    explicit RoamMesh(SplitBounds bounds, Driver driver = Driver::wheel,
                      LeafPlacement placement = LeafPlacement::inOrder);

    /// Takes effect with the next refinement.
    void setDriver(Driver driver);
    Driver driver() const { return _driver; }

    /// Adapts to an eye. Errors are bounded in the whole picture (ViewState::guaranteedPixelsPerTangent).
    /// The triangle ceiling binds the whole frame: τ rises until the mesh fits, and while it binds follows the number of
    /// leaves, so that they stay within 1 % (or 4) below it (TriangleCeiling.h finds τ anew where it leaps; the queue merges
    /// what matters least). Patches count with all their triangles; two are always drawn. A ceiling that comes down in a
    /// sliced frame is met as soon as the slices allow. The time slice stops the work where it is, and the next call goes
    /// on: the wheel with what is left over, the others from the start.
    /// Frame of `view`: the tile's local frame. Cost: the driver's.
    RefineResult refine(const viewlod::ViewState& view, const viewlod::Budget& budget);

    /// Morphing: from the next refinement for an eye on, vertices come and go without a jump, and the error target holds
    /// for what is drawn; the mesh is refined to two thirds of it (Morph). Patches do not morph: with them it stays off.
    void setMorphing(bool on) { _isMorphing = on && !patches(); }
    bool isMorphing() const { return _isMorphing; }

    /// View-independent: a vertex is active exactly when e_v > errorM.
    RefineResult refine(double errorM);

    /// Whether the tile has been edited since the last refinement.
    bool isBehind() const { return _revision != tile().revision(); }

    /// GPU-ready data by slot, and what the last refinement changed of them. Slots that are not in use have any content.
    std::uint32_t vertexSlots() const { return _tree.vertexSlots(); }
    std::uint32_t triangleSlots() const { return _tree.leaves().slotCount(); }
    MeshVertex vertex(VertexSlot v) const { return _tree.place(v).isFree() ? MeshVertex{} : _tree.vertex(v); }
    LeafTriangle triangle(std::uint32_t slot) const
    {
        const TriangleId leaf = _tree.leaves().leaf(slot);
        return leaf.exists() ? _tree.vertices(leaf) : LeafTriangle{};
    }
    const MeshChanges& changes() const { return _tree.changes(); }

    /// Where leaves carry patches, those are what is drawn, and have slots of their own; null: they do not.
    const PatchPool* patches() const { return _patches ? &*_patches : nullptr; }
    int patchExponent() const { return _tree.bounds().patchExponent(); }

    /// Ranges of slots, of triangles or of patches, that can be seen: conservative, by regions of the tree (RegionBounds),
    /// then patch by patch. Only ranges given here hold live ones, and gaps: triangles without extent (triangle() says so
    /// too). Appends to `ranges`. Returns the number of triangles in them, gaps not counted.
    std::uint32_t visibleRanges(const viewlod::Frustum& frustum, std::vector<IndexRange>& ranges) const;

    /// The same, near ones first, so that the depth test spares what they hide: about half the fragments in hills; and
    /// without those that are wholly below the horizon, where one is given.
    std::uint32_t visibleRanges(const viewlod::Frustum& frustum, const glm::dvec3& eye,
                                const Horizon* horizon, std::vector<IndexRange>& ranges) const;

    /// For a camera that looks along rays from the eye that the mesh was last refined for, its horizon. None for any other
    /// eye, and where it cannot be told.
    std::optional<Horizon> horizon(const glm::dvec3& eye) const;

    /// The same without any camera: all that there is to draw.
    std::vector<IndexRange> allRanges() const;

    /// What such ranges draw; all that there is to draw.
    DrawnMesh drawn(std::span<const IndexRange> ranges) const;
    DrawnMesh drawn() const;

    const DiamondTree& tree() const { return _tree; }
    const RoamTile& tile() const { return _tree.tile(); }
    bool isConforming() const { return _tree.isConforming(); }
    std::size_t memoryBytes() const
    {
        return _tree.memoryBytes() + _wheel.memoryBytes() + (_patches ? _patches->memoryBytes() : 0);
    }

private:
    RefineResult adapt(const viewlod::ViewState& view, const viewlod::Budget& budget);
    RefineResult adaptAndMorph(const viewlod::ViewState& view, const viewlod::Budget& budget);
    std::uint32_t appendRanges(const std::vector<std::uint32_t>& regions, const viewlod::Frustum& frustum,
                               std::vector<IndexRange>& ranges) const;
    std::uint32_t appendPatches(std::uint32_t region, const viewlod::Frustum& frustum,
                                std::vector<IndexRange>& ranges) const;
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
    std::optional<PatchPool> _patches;
    Morph _morph;
    std::uint64_t _revision = 0;  ///< of the tile, that the mesh has followed
    std::vector<GridRect> _moved; ///< where vertices of patches may lie elsewhere
    bool _isMorphing = false;
    bool _ceilingBound = false; ///< in the last frame
    double _lastTolerancePx = 0.0;
    std::optional<glm::dvec3> _eye; ///< last refined for
    double _errorPerM = 0.0;        ///< by how much of its distance from there what is drawn may be off
    double _nearM = 0.0;
};

} // namespace osgTerrainROAM::core
