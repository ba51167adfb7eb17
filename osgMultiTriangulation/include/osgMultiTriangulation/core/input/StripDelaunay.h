// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// Triangulates points after Delaunay strip by strip, for sets that do not fit into memory. A triangle is
/// finished once all points of its circle have come; points that no unfinished triangle has are forgotten.
/// The sides between finished and unfinished triangles are sides of every Delaunay triangulation of a subset
/// with their ends, so the unfinished area is triangulated anew with each strip, and what lies beyond those
/// sides is left out.
/// Memory: about 500 B for each point of a strip and of the front, some rows of points along its end.
/// Source: after Isenburg, Liu, Shewchuk & Snoeyink, *Streaming computation of Delaunay triangulations*
/// (2006). Differs: each step is the whole algorithm of delaunay() on strip and front; no incremental
/// insertion.
class StripDelaunay
{
public:
    /// `emit`: gets each triangle once, counter-clockwise, corners as numbers of points in the order they
    /// were added.
    /// `axis`: along which strips follow each other, 0 x, 1 y. `high`: the greatest coordinates of all
    /// points.
    StripDelaunay(std::function<void(const Triangle&)> emit, std::uint32_t axis,
                  std::array<std::int32_t, 2> high);

    /// Adds a strip. No two points are at one place, none has a lesser coordinate along the axis than was
    /// told to advance().
    void add(std::span<const SurfacePoint> points);

    /// Gives out what is finished now. `next`: no later point has a lesser coordinate along the axis.
    /// Errors: nearly equal circles were told apart differently in two steps.
    foundation::Outcome advance(std::int32_t next);

    /// After the last strip: gives out the rest. Errors: as above.
    foundation::Outcome finish();

private:
    /// A side from one point to another, as the unfinished triangle on its left has it; both by number.
    struct Side
    {
        std::uint32_t from, to;
        auto operator<=>(const Side&) const = default;
    };

    struct Piece
    {
        Triangle corners; ///< numbers in _points
        bool isFinished = false, isBeyond = false;
    };

    foundation::Outcome step(double next);
    void triangulate(double next);
    void indexSides();
    std::uint32_t pieceAt(Side side) const;
    bool leaveOutFinished();
    void keepFront(double next);
    bool isHullForGood(const Side& outer, double next) const;

    std::function<void(const Triangle&)> _emit;
    std::uint32_t _axis;
    std::array<std::int32_t, 2> _high;
    std::uint32_t _added = 0;
    std::vector<SurfacePoint> _points;   ///< of the front and the strip
    std::vector<std::uint32_t> _numbers; ///< by point, among all
    std::vector<Side> _front;            ///< sorted; ends are numbers in _points
    std::vector<Piece> _pieces;
    std::vector<std::pair<Side, std::uint32_t>> _pieceOf; ///< by side, sorted
};

} // namespace osgMultiTriangulation::core
