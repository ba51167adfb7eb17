// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// A vertex that merges into a neighbour: all triangles of its hole meet at the neighbour.
struct VertexCollapse
{
    std::uint32_t vertex = 0, into = 0; ///< points of the mesh
};

/// Returns the half-edge collapses that simplify a surface as far as it goes, the one that leaves the least
/// vertical error over all points first. It is buildTree() with holes filled by a fan instead of by their
/// best triangulation, so that each removal is a collapse; the limits on outline and neighbours are the same.
/// `mesh`: valid (SurfaceCheck.h). Deterministic. Cost and memory: as buildTree().
std::vector<VertexCollapse> collapseOrder(const SurfaceMesh& mesh);

} // namespace osgMultiTriangulation::core
