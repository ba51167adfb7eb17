// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <viewlod/Budget.h>
#include <viewlod/Sight.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/Horizon.h>
#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/PatchPool.h>
#include <osgTerrainROAM/core/roam/RefineResult.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// The triangulation of one terrain tile for one view group, by one method (Method.h): it follows the eye
/// from frame to frame. Vertices and triangles have slots, those of buffers on the graphics card. A
/// refinement writes some of them and reports which.
/// Invariant: isValid() after every operation. Threads: one at a time; if the tile is edited, with a shared
/// lock of its mutex.
/// Cost of the interface: a virtual call for each refinement, range of slots or query, none for a vertex or
/// triangle.
/// Frame: the tile's local frame. Units: metres, unless a name says otherwise.
class TerrainMesh
{
public:
    virtual ~TerrainMesh() = default;

    virtual const RoamTile& tile() const = 0;

    /// Adapts to an eye: no sample that is visible beyond the near distance is drawn farther from its true
    /// place than the tolerance, anywhere in the frame (ViewState::guaranteedPixelsPerTangent). Where the
    /// ceiling of triangles binds, the tolerance rises for the whole frame, and the result tells it.
    virtual RefineResult refine(const viewlod::ViewState& view, const viewlod::Budget& budget) = 0;

    /// Refines for no eye in particular: no sample is farther from the mesh than errorM.
    virtual RefineResult refine(double errorM) = 0;

    /// From the next refinement for an eye, detail comes and goes without a jump, and the tolerance holds for
    /// the drawn surface. A method that does not morph ignores it; checkMethod() refuses it before.
    virtual void setMorphing(bool on) = 0;

    /// From the next refinement for an eye, only what is in sight is refined; the tolerance holds there, and
    /// the rest is as coarse as the mesh allows. A method that refines all around ignores it; checkMethod()
    /// refuses it before.
    virtual void setSight(const viewlod::Sight&) {}

    /// Whether the tile has been edited since the last refinement.
    virtual bool isBehind() const = 0;

    /// The data for the graphics card by slot. Unused slots have any content; unused triangles have no
    /// extent.
    virtual std::uint32_t vertexSlots() const = 0;
    virtual std::uint32_t triangleSlots() const = 0;
    virtual void appendVertices(IndexRange slots, std::vector<MeshVertex>& vertices) const = 0;
    virtual void appendTriangles(IndexRange slots, std::vector<LeafTriangle>& triangles) const = 0;

    /// The slots that the last refinement wrote.
    virtual const MeshChanges& changes() const = 0;

    /// The patches, which are drawn instead of the triangles and have slots of their own; null: there are
    /// none.
    virtual const PatchPool* patches() const { return nullptr; }

    /// Appends the vertices of the patch in a slot. Precondition: patches().
    virtual void appendPatch(std::uint32_t, std::vector<MeshVertex>&) const {}

    /// Appends the ranges of slots (of triangles or of patches) that may be visible: conservative. Only these
    /// ranges hold live slots; they also hold gaps, triangles without extent. Returns the number of triangles
    /// in them, gaps not counted.
    virtual std::uint32_t visibleRanges(const viewlod::Frustum& frustum,
                                        std::vector<IndexRange>& ranges) const = 0;

    /// Does the same, near ranges first, so that the depth test saves hidden fragments. With a horizon it
    /// omits ranges that are wholly below it.
    virtual std::uint32_t visibleRanges(const viewlod::Frustum& frustum, const glm::dvec3& eye,
                                        const Horizon* horizon, std::vector<IndexRange>& ranges) const = 0;

    /// The horizon for a camera at the eye that the mesh was last refined for. None for any other eye, and
    /// where it is not certain.
    virtual std::optional<Horizon> horizon(const glm::dvec3&) const { return std::nullopt; }

    /// All ranges, without a camera.
    std::vector<IndexRange> allRanges() const;

    /// The mesh that such ranges draw; the whole mesh.
    virtual DrawnMesh drawn(std::span<const IndexRange> ranges) const = 0;
    DrawnMesh drawn() const { return drawn(allRanges()); }

    /// The distance from a point to the drawn surface, or less: no near plane may lie beyond.
    virtual double nearestM(const glm::dvec3& point) const = 0;

    /// Calls visit(corners, triangle) for the drawn triangles that touch the border of the data from inside,
    /// and perhaps for others: skirts hang there. Not with patches.
    using BorderVisit = std::function<void(const GridPoint (&corners)[3], const LeafTriangle& triangle)>;
    virtual void forEachTriangleAtBorder(const BorderVisit& visit) const = 0;

    /// Checks the invariants of the method's structures. Cost: that of visiting all of them.
    virtual bool isValid() const = 0;

    /// Of this mesh alone, without what the meshes of a tile share.
    virtual std::size_t memoryBytes() const = 0;

protected:
    TerrainMesh() = default;
    TerrainMesh(const TerrainMesh&) = default;
    TerrainMesh& operator=(const TerrainMesh&) = default;
};

} // namespace osgTerrainROAM::core
