// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <osgTerrainROAM/core/blocks/BlockBounds.h>
#include <osgTerrainROAM/core/blocks/BlockSlots.h>
#include <osgTerrainROAM/core/roam/TerrainMesh.h>

namespace osgTerrainROAM::core
{

/// The part of a mesh of blocks that does not depend on how a block is simplified: slots of each block,
/// culling, queries. Each block has a run of vertex slots and a run of triangle slots; it shares none with
/// its neighbours.
/// Memory: 24 B a vertex slot, 12 B a triangle slot.
class BlockMesh : public TerrainMesh
{
public:
    std::uint32_t vertexSlots() const override { return static_cast<std::uint32_t>(_vertices.size()); }
    std::uint32_t triangleSlots() const override { return static_cast<std::uint32_t>(_triangles.size()); }
    void appendVertices(IndexRange slots, std::vector<MeshVertex>& vertices) const override;
    void appendTriangles(IndexRange slots, std::vector<LeafTriangle>& triangles) const override;
    const MeshChanges& changes() const override { return _changes; }

    std::uint32_t visibleRanges(const viewlod::Frustum& frustum,
                                std::vector<IndexRange>& ranges) const override;
    std::uint32_t visibleRanges(const viewlod::Frustum& frustum, const glm::dvec3& eye,
                                const Horizon* horizon, std::vector<IndexRange>& ranges) const override;
    DrawnMesh drawn(std::span<const IndexRange> ranges) const override;
    using TerrainMesh::drawn;

    double nearestM(const glm::dvec3& point) const override;
    void forEachTriangleAtBorder(const BorderVisit& visit) const override;
    bool isValid() const override;
    std::size_t memoryBytes() const override;

protected:
    BlockMesh(const BlockGrid& grid, double stepM) : _grid(grid), _stepM(stepM), _runs(grid.count()) {}

    const BlockGrid& grid() const { return _grid; }
    virtual const BlockBox& box(std::uint32_t block) const = 0;

    /// Starts a refinement.
    void clearChanges() { _changes.clear(); }

    /// A vertex of a block, to be written.
    struct Vertex
    {
        glm::dvec3 position;
        GridPoint place;
    };

    /// Writes all vertices of a block; the run keeps its place if it has room for `capacity`, no more and no
    /// less. The first `sunk` of them hang below their samples.
    void writeVertices(std::uint32_t block, std::span<const Vertex> vertices, std::uint32_t capacity,
                       std::uint32_t sunk = 0);

    /// Writes all triangles of a block, by the numbers of its vertices. The last `ofRim` of them lie outside
    /// the block, under others.
    void writeTriangles(std::uint32_t block, std::span<const LeafTriangle> triangles, std::uint32_t capacity,
                        std::uint32_t ofRim = 0);

    std::uint32_t triangleCount() const { return _triangleCount; }
    IndexRange vertexRun(std::uint32_t block) const { return _runs[block].vertices; }
    bool isWritten(std::uint32_t block) const { return _runs[block].triangles.count > 0; }

    bool _isMorphed = false; ///< vertices need not lie where their samples are

private:
    struct Run
    {
        IndexRange vertices, triangles;
        std::uint32_t triangleCount = 0; ///< of those slots that are used, from the first
        std::uint32_t ofRim = 0;         ///< the last of them
        std::uint32_t sunk = 0;          ///< vertices, from the first
    };

    void append(std::uint32_t block, std::vector<IndexRange>& ranges) const;
    double nearestM(std::uint32_t block, const glm::dvec3& point) const;

    BlockGrid _grid;
    double _stepM;
    std::vector<Run> _runs; ///< by block
    BlockSlots _vertexSlots, _triangleSlots;
    std::vector<MeshVertex> _vertices; ///< by slot
    std::vector<GridPoint> _places;    ///< of the vertices
    std::vector<LeafTriangle> _triangles;
    MeshChanges _changes;
    std::uint32_t _triangleCount = 0;
};

} // namespace osgTerrainROAM::core
