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

/// A mesh whose positions have been drawn together, cell by cell.
struct ClusteredMesh
{
    Mesh mesh; ///< positions as before; those that represent nothing are used by no face
    double cellSize = 0.0;
    std::vector<std::uint32_t> representative; ///< by position: the one of its cell
    std::size_t cells = 0;                     ///< with positions that faces use
    std::size_t degenerateFaces = 0;           ///< dropped: an edge or a point is left of them
    std::size_t duplicateFaces = 0; ///< dropped: same corners, front, material and part as an earlier one
    /// What is left of degenerate faces and is part of no face, each once: what was thin becomes a line, what was small a point.
    std::vector<std::array<std::uint32_t, 2>> edges;
    std::vector<std::uint32_t> points;
};

/// The weight of every position: how likely it is seen on a silhouette, times how large the faces are that it bounds. That is the length of its
/// longest edge, over the largest angle between two of its edges in one plane with it (radians): a tip has a small one. 0: no face.
std::vector<double> clusterGrades(const Mesh& mesh);

/// Cuts the mesh's box into cubes of `cellSize`, beginning at its low corner, and moves every position to that of the highest grade in
/// its cube (of equal ones the lowest number). A static method: one level for a size, without regard to topology: parts that lie close join,
/// and thin ones become lines.
/// Guarantee: no point of the surface moves farther than a cell's diagonal, and with `edges` and `points` the surfaces are not farther
/// apart either way.
/// Corners keep their attributes: a texture is stretched as the position moves, and no picture of another chart comes in.
/// Errors: a cell size that is not above zero, or a billionth of the mesh's box. Cost: n log n. Units: as the positions.
/// Source: Rossignac and Borrel, "Multi-resolution 3D approximations for rendering complex scenes" (1993): grading, clustering,
/// synthesis, elimination. They add two weights of different units; we multiply, which needs no factor between them. Normals stay.
foundation::Result<ClusteredMesh> clusterVertices(const Mesh& mesh, double cellSize);

/// What keeps a clustering from being one of the mesh; empty: nothing does. Every position has to be drawn to one of its own cell, faces to
/// be the mesh's with their corners moved, in order, and degenerates and duplicates to be accounted for.
std::string clusteringDefectOf(const ClusteredMesh& clustered, const Mesh& mesh);

} // namespace osgPMObjects::core
