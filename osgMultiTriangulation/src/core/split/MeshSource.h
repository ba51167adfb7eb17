// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "PartSource.h"

namespace osgMultiTriangulation::core
{

/// A surface in memory, with its triangles by part. Memory: 9 B a triangle.
class MeshSource : public PartSource
{
public:
    /// `mesh` and `partition` must stay.
    MeshSource(const SurfaceMesh& mesh, const Partition& partition);

    std::unique_ptr<Points> points() const override;
    std::vector<Triangle> trianglesOf(std::uint32_t part) const override;

private:
    const SurfaceMesh& _mesh;
    std::vector<std::uint32_t> _trianglesOf; ///< triangles of the mesh, by the smallest part that holds them
    std::vector<std::uint32_t> _firstOf;     ///< by part, and one more
    std::vector<std::uint8_t> _joinedAt;     ///< by point
};

} // namespace osgMultiTriangulation::core
