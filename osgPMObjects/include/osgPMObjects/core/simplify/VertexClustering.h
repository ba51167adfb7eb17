// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// A mesh whose positions have been merged, one for each cell of a grid.
struct ClusteredMesh
{
    Mesh mesh; ///< all positions are kept; faces use only representatives
    double cellSize = 0.0;
    std::vector<std::uint32_t> representative; ///< by position: the representative of its cell
    std::size_t cells = 0;                     ///< number of cells with positions that faces use
    std::size_t degenerateFaces = 0;           ///< dropped: collapsed to an edge or a point
    std::size_t duplicateFaces =
        0; ///< dropped: an earlier face has the same corners, front, material and part
    /// Edges and points of degenerate faces that no remaining face contains, each once: thin things become
    /// lines, small ones points.
    std::vector<std::array<std::uint32_t, 2>> edges;
    std::vector<std::uint32_t> points;
};

/// Computes the weight of every position: large where it is likely on a silhouette and its faces are large.
/// It is the length of its longest edge, divided by the largest angle (radians) between two of its edges. 0:
/// no face.
std::vector<double> clusterGrades(const Mesh& mesh);

/// Merges all positions in each cube of a grid into the one of the highest weight (of equal ones the lowest
/// number). The grid begins at the low corner of the mesh's box. This is a static method: it makes one level
/// for one cell size, and ignores topology: near parts join, and thin ones become lines.
/// Guarantee: no point of the surface moves farther than a cell's diagonal; the distance between both
/// surfaces, `edges` and `points` included, is at most that, both ways. Corners keep their attributes, so a
/// texture is stretched and never shows another chart. Normals are kept.
/// Errors: a cell size that is not above zero, or below a billionth of the mesh's box. Cost: n log n. Units:
/// as the positions.
/// Source: Rossignac and Borrel, *Multi-resolution 3D approximations for rendering complex scenes* (1993):
/// grading, clustering, synthesis, elimination. Differs: they add two weights of different units; we
/// multiply, which needs no factor between them.
foundation::Result<ClusteredMesh> clusterVertices(const Mesh& mesh, double cellSize);

/// Checks that a clustering fits the mesh; returns a description of the first defect, or an empty string.
/// Every position must have a representative in its own cell; faces must be the mesh's in order with corners
/// replaced, less the counted degenerates and duplicates.
std::string clusteringDefectOf(const ClusteredMesh& clustered, const Mesh& mesh);

} // namespace osgPMObjects::core
