// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <viewlod/Budget.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/BinTriangleTree.h>
#include <osgTerrainROAM/core/roam/LeafArena.h>

namespace osgTerrainROAM::core
{

/// What one refinement did.
struct RefineResult
{
    std::uint32_t triangles = 0; ///< leaves that overlap the data: what is there to draw
    std::uint32_t leaves = 0; ///< all leaves, those beyond the data's edge included: what the ceiling counts
    std::uint32_t splits = 0; ///< triangles split, forced ones included
    std::uint32_t merges = 0; ///< triangles merged back
    double tolerancePx = 0.0; ///< τ reached: the target, or what the triangle ceiling allowed (0: none asked)
    bool ceilingBound = false; ///< the ceiling raised τ
};

/// The triangulation of one terrain tile for one view group: it follows the eye from frame to frame.
/// A vertex is *active* exactly when K·e_v / max(|eye − X_v| − r_v, n) > τ; this nests, so the active set is a
/// conforming mesh, the same for a given eye whatever came before.
/// Driver: the paper's recursive walk over the previous frame's tree (§5.2), forceSplit where a leaf's vertex is
/// active, enhMerge where a split vertex is not.
/// Invariant: isConforming() after every operation. Threads: one at a time; the tile is shared and immutable.
/// Memory: 64 B per bintree node, 12 B per leaf, 32 B per vertex; pools grow, and no split allocates otherwise.
/// Source: "Methods of continuous level of detail for terrain" (2002), §5; spec 1 D.
class RoamMesh
{
public:
    explicit RoamMesh(std::shared_ptr<const RoamTile> tile);

    /// Adapts to an eye. Errors are bounded in the whole picture (ViewState::guaranteedPixelsPerTangent).
    /// The triangle ceiling binds the whole frame: τ rises until the mesh fits (TriangleCeiling.h). The time budget is
    /// not consulted: this driver finishes the frame it has begun.
    /// Frame of `view`: the tile's local frame. Cost: one visit per node of the mesh, plus the changes.
    RefineResult refine(const viewlod::ViewState& view, const viewlod::Budget& budget);

    /// View-independent: a vertex is active exactly when e_v > errorM.
    RefineResult refine(double errorM);

    /// GPU-ready data and what the last refinement changed of them.
    std::span<const MeshVertex> vertices() const { return _tree.vertices(); }
    std::span<const LeafTriangle> triangles() const { return _tree.leaves().triangles(); }
    const MeshChanges& changes() const { return _tree.changes(); }

    /// Ranges of triangles() that can be seen: conservative, by regions of the tree (RegionBounds).
    /// Only ranges given here hold live triangles. Appends to `ranges`.
    void visibleRanges(const viewlod::Frustum& frustum, std::vector<TriangleRange>& ranges) const;

    const BinTriangleTree& tree() const { return _tree; }
    const RoamTile& tile() const { return *_tile; }
    bool isConforming() const { return _tree.isConforming(); }

private:
    std::shared_ptr<const RoamTile> _tile;
    BinTriangleTree _tree;
    bool _ceilingBound = false; ///< in the last frame
    double _lastTolerancePx = 0.0;
};

} // namespace osgTerrainROAM::core
