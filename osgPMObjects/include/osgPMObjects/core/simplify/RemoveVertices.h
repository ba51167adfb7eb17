// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/RemovalSequence.h>

namespace osgPMObjects::core
{

/// The most faces around a position that can be removed. Others wait until neighbours have been removed.
constexpr std::size_t kMostStarFaces = 127;

/// The order of removal.
enum class RemovalOrder
{
    flattest,   ///< nearest to the mean plane of its star first
    asNumbered, ///< in the order of their numbers; this and the next are for comparison
    shuffled,   ///< in a pseudo-random order, always the same
};

/// How the hole of a removed position is filled.
enum class HoleTriangulation
{
    delaunay, ///< triangulateContour()
    /// All new faces meet at one position of the contour, so a progressive mesh can play the removal:
    /// collapsesOf(). Of the positions at which no face folds over, the one with the largest least angle of a
    /// new face is taken. A position where several fans touch stays.
    fan,
};

struct RemovalOptions
{
    std::vector<bool> isSupport{}; ///< by position: not to be removed; empty: none. See supportVertices()
    double creaseAngleDeg = 40.0;  ///< a star with just two sharper edges is cut along them; 180: none is
    RemovalOrder order = RemovalOrder::flattest;
    HoleTriangulation triangulation = HoleTriangulation::delaunay;
    bool removeParts = true; ///< remove a group of faces when it is smaller than the error reached
};

/// Removes one position a step, with all its faces, until none can be removed. triangulateContour() fills the
/// hole in the plane that fits its contour best.
/// The order is by distance: of the position from the mean plane of its star (normals and centres weighted by
/// area), and on a boundary, seam or crease also from the line between its two neighbours along it; plus the
/// error of the faces around it so far. A hole on a boundary is closed by one edge. A star that is crossed by
/// a seam, a border of materials or parts, or a crease, is cut there into two contours, each filled with its
/// own wedges, material and part. Where a seam ends or branches, the position stays. A position where several
/// fans touch is removed with all of them. A refused position is tried again when its star has changed, and
/// at the end. A connected group is removed as a whole at an error of the diagonal of its box, but never with
/// the last face of a material or with a support vertex. RemovalStep::error is the largest sum so far of two
/// numbers: the distance of a position from the faces that fill its hole, and the error of the faces around
/// it before. It estimates and does not bound; docs/measurements/support-vertices.md compares it with
/// measured distances.
/// `mesh`: valid (MeshCheck.h), best consolidated: positions at non-manifold edges or between faces of
/// opposite orientation stay.
/// Deterministic: of equal distances the lower position is removed first. Cost: 7 µs a step. Memory: at most
/// 400 B a position.
/// Source: Sadykov & Zakharov, *Choosing the level of detail in continuous simplification of polygonal
/// objects* (2002), section 3, which gives no order and no tests; distances and cuts along edges after
/// Schroeder, Zarge and Lorensen, *Decimation of triangle meshes* (1992), sections 3.2 and 3.3.
RemovalSequence removeVertices(const Mesh& mesh, const RemovalOptions& options = {});

} // namespace osgPMObjects::core
