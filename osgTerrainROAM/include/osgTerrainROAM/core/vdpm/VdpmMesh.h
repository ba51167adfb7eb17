// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <viewlod/Budget.h>
#include <viewlod/Sight.h>
#include <viewlod/Slice.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/RoamTile.h>
#include <osgTerrainROAM/core/roam/TerrainMesh.h>
#include <osgTerrainROAM/core/vdpm/FrontDriver.h>

namespace osgTerrainROAM::core
{

/// The triangulation of one terrain tile for one view group by a view-dependent progressive mesh.
/// In error-target mode the mesh depends on the eye alone. Where the ceiling of triangles binds, the
/// tolerance rises for the whole frame; which of the tolerances within 1 % of the ceiling it is depends on
/// the frames before.
/// The tile must not be edited: progressive meshes follow no edits. With morphing it depends on what came
/// before, too.
/// Invariant: isValid(). Threads: one at a time. Memory: memoryBytes(); the forest is shared.
/// Source: Hoppe, *View-dependent refinement of progressive meshes*, 1997; *Methods of continuous level of
/// detail for terrain* (Graphicon 2002), section 4.4. Differs: triangles of unknown error cannot appear
/// (VertexForest::dependencies), so no sample is off by more than the tolerance.
class VdpmMesh final : public TerrainMesh
{
public:
    /// `forest`: of the tile (heightFieldForest()).
    VdpmMesh(std::shared_ptr<const RoamTile> tile, std::shared_ptr<const BoundedForest> forest);

    const RoamTile& tile() const override { return *_tile; }

    /// As TerrainMesh::setSight(); then every frame checks the whole front.
    void setSight(const viewlod::Sight& sight) override;

    RefineResult refine(const viewlod::ViewState& view, const viewlod::Budget& budget) override;
    RefineResult refine(double errorM) override;
    void setMorphing(bool on) override { _isMorphing = on; }
    bool isBehind() const override { return false; }

    /// Slots of triangles have no gaps.
    std::uint32_t vertexSlots() const override { return _driver.front().vertexSlots(); }
    std::uint32_t triangleSlots() const override { return _driver.front().faceCount(); }
    void appendVertices(IndexRange slots, std::vector<MeshVertex>& vertices) const override;
    void appendTriangles(IndexRange slots, std::vector<LeafTriangle>& triangles) const override;
    const MeshChanges& changes() const override { return _driver.front().changes(); }

    /// One range of everything: slots do not lie by place, so nothing is culled.
    std::uint32_t visibleRanges(const viewlod::Frustum& frustum,
                                std::vector<IndexRange>& ranges) const override;
    std::uint32_t visibleRanges(const viewlod::Frustum& frustum, const glm::dvec3& eye,
                                const Horizon* horizon, std::vector<IndexRange>& ranges) const override;
    DrawnMesh drawn(std::span<const IndexRange> ranges) const override;
    using TerrainMesh::drawn;

    /// Cost: all triangles.
    double nearestM(const glm::dvec3& point) const override;
    void forEachTriangleAtBorder(const BorderVisit& visit) const override;

    const FrontDriver& driver() const { return _driver; }
    bool isValid() const override { return _driver.front().isConforming() && _driver.keepsDependencies(); }
    std::size_t memoryBytes() const override { return _driver.memoryBytes(); }

private:
    bool runWithinCeiling(const viewlod::ViewState& view, const viewlod::Budget& budget,
                          viewlod::Slice& slice, RefineResult& result);
    glm::dvec3 positionAt(std::uint32_t slot) const;
    GridPoint gridAt(std::uint32_t slot) const;

    std::shared_ptr<const RoamTile> _tile;
    std::shared_ptr<const BoundedForest> _forest;
    FrontDriver _driver;
    viewlod::Sight _sight;
    bool _isMorphing = false;
    bool _hasRefined = false;
    bool _ceilingBound = false; ///< in the last frame
    double _lastTolerancePx = 0.0;
};

} // namespace osgTerrainROAM::core
