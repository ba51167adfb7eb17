// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include <osgMultiTriangulation/core/build/MeasuredMesh.h>
#include <osgMultiTriangulation/core/structure/MultiTriangulation.h>

namespace osgMultiTriangulation::core
{

/// How far to simplify.
struct TreeOptions
{
    std::vector<bool> isLocked{}; ///< by point of the mesh: must stay; empty: none
    std::size_t keep = 0;         ///< end once no more points are left
};

/// What simplification gives.
struct BuiltTree
{
    MultiTriangulation tree;             ///< its drain is the input
    std::vector<std::uint32_t> points;   ///< by point of the tree: its number in the input mesh
    std::vector<std::uint32_t> triangle; ///< by triangle of the input mesh: its number in the tree
    MeasuredMesh rest;                   ///< the root of the tree, with all that it hides
};

/// Builds a multi-triangulation by removing vertices, one at a time. The vertex whose removal leaves the
/// least vertical error over all points of the input goes first. Of all triangulations of its hole the one
/// with the least error is taken. Every triangle gets its own error, exact but for rounding up. Heights stay
/// those of the input, so the drain is the input. The outline stays: of its points only those on a straight
/// part of it can go. A vertex with more than 9 neighbours waits until it has fewer.
/// The order is that of a lazy queue: a vertex whose neighbours have changed is judged anew only when it
/// comes to the front, at first by the worst few points of its triangles, then by all.
/// `input`: its mesh is valid (SurfaceCheck.h). Deterministic. Cost: 9 to 11 µs a point (on a busy machine).
/// Memory: about 400 B a point.
/// Source: the order is that of Schroeder, Zarge & Lorensen, *Decimation of triangle meshes* (1992), with the
/// exact error of triangles instead of a distance to a plane.
BuiltTree buildTree(const MeasuredMesh& input, const TreeOptions& options = {});

} // namespace osgMultiTriangulation::core
