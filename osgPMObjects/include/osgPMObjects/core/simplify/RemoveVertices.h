// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/RemovalSequence.h>

namespace osgPMObjects::core
{

/// Positions with more faces around them wait until neighbours have gone.
constexpr std::size_t kMostStarFaces = 127;

/// Which position goes next.
enum class RemovalOrder
{
    flattest, ///< the one nearest to the mean plane of its star
    asNumbered, ///< the first that can go. Paper 004 gives no order: this and the next are there to compare with
    shuffled, ///< any, in an order that looks like chance and is always the same
};

struct RemovalOptions
{
    std::vector<bool> isSupport{}; ///< by position: those that stay; empty: none. See SupportVertices.h
    double creaseAngleDeg =
        40.0; ///< where just two edges of a star are sharper, it is removed along them; 180: nowhere
    RemovalOrder order = RemovalOrder::flattest;
    bool removeParts =
        true; ///< a group of faces goes when it is smaller than the error that has been reached
};

/// Removes one position a step, with all its faces, as long as any can be removed, and fills the hole by triangulateContour() in the
/// plane that fits its contour best. Next goes the position nearest to the mean plane of its star (normals and centres weighted
/// by area), on a boundary, a seam or a crease also to the line between its two neighbours along it; to this distance that is added by
/// which the faces around it are off already.
/// A hole on a boundary is closed by one edge. A star with a seam through it, or a border of materials or parts, or a crease,
/// is cut into two contours along it, each filled with its own wedges, material and part; where a seam ends or branches
/// the position stays. Positions where several fans touch are removed with all of them. What was refused is tried again when its
/// star has changed, and when nothing else is left. Whole groups go at an error of the diagonal of their box, but never the last face of
/// a material, nor what has a support vertex.
/// RemovalStep::error is the largest sum so far of a position's distance from the faces that fill its hole, and of what the faces around it
/// were off before. An estimate and no bound; docs/algorithms/support-vertices.md has it beside what is measured.
/// `mesh`: valid (MeshCheck.h), consolidated for best results: crowded edges and faces in the wrong sense are left alone.
/// Deterministic: of equal distances the lower position goes first. Cost: 7 µs a step, see docs/algorithms/support-vertices.md.
/// Memory: 400 B a position at the peak.
/// Source: paper 004, §3, which gives no order and no tests; spec 5, "One vertex per step"; distances and the cutting along edges after
/// Schroeder, Zarge and Lorensen, "Decimation of triangle meshes" (1992), §3.2–3.3.
RemovalSequence removeVertices(const Mesh& mesh, const RemovalOptions& options = {});

} // namespace osgPMObjects::core
