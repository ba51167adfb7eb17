// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "Lanes.h"

namespace osgMultiTriangulation::core
{

/// Finds, among all triangulations of a hole, the one whose greatest vertical error at given points is least;
/// of several, the one with the least sum of squared errors. The hole is the polygon that the star of a
/// removed vertex leaves. Coordinates are relative to that vertex.
/// Use: begin(), add() for each point, solve(); more points may be added then, and solved anew.
/// Cost: O(m³) for m corners, and for each point O(m²) sides and the triangles that contain it.
/// Source: dynamic programming over the diagonals of a polygon, Klincsek, *Minimal triangulations of
/// polygonal domains* (1980).
/// Differs: the weight of a triangulation is its greatest error, not a sum of lengths.
/// Threads: one; its memory is reused.
class HoleTriangulation
{
public:
    static constexpr int kMostCorners = 9;
    static constexpr std::size_t kMostPoints = 64;

    struct Point
    {
        double x, y, height;
    };

    /// A triangle by the numbers of its corners, rising.
    struct Piece
    {
        std::uint8_t i, j, k;
    };

    struct Pieces
    {
        std::array<Piece, kMostCorners - 2> all;
        std::size_t count = 0;

        operator std::span<const Piece>() const { return std::span(all).first(count); }
    };

    /// height = slopeX · x + slopeY · y + base.
    struct Plane
    {
        double slopeX, slopeY, base;

        double distance(const Point& p) const
        {
            return std::abs(slopeX * p.x + slopeY * p.y + base - p.height);
        }
    };

    /// A point lies left of a line when x · p.x + y · p.y >= least; exact.
    struct Line
    {
        double x, y, least;

        bool isLeft(const Point& p) const { return x * p.x + y * p.y >= least; }
    };

    static Plane planeOf(const Point& a, const Point& b, const Point& c);
    static Line lineOf(const Point& from, const Point& to)
    {
        const double x = from.y - to.y, y = to.x - from.x;
        return {x, y, x * from.x + y * from.y};
    }

    /// Starts over with a simple polygon: its corners, counter-clockwise; 3 … kMostCorners.
    void begin(std::span<const Point> corners);

    /// Adds a point in the hole at which the surface is known; kMostPoints at most.
    void add(const Point& point);

    /// Returns whether there is a triangulation at all (without triangles of no area).
    bool solve();

    /// The same among the fans: the triangulations whose triangles all have one corner. `isAtBorder`: only
    /// the first corner and the last may be that corner, as on a border, where the side between these two is
    /// to become the outline.
    bool solveFan(bool isAtBorder);

    /// Returns the greatest error of the triangulation found.
    double error() const { return _best[0][_count - 1].error; }
    double squares() const { return _best[0][_count - 1].squares; }

    /// Returns what was found in one number: the triangles follow from it and the corners. After solve(), and
    /// after solveFan().
    std::uint32_t code() const;
    std::uint32_t codeOfFan() const { return static_cast<std::uint32_t>(_apex); }

    /// Returns the triangles of a hole of `count` corners, `count - 2`, by the code of what was found.
    static Pieces pieces(std::uint32_t code, int count);
    static Pieces piecesOfFan(std::uint32_t code, int count);

private:
    static constexpr int kMostPieces = 84; ///< kMostCorners choose 3

    /// A triangle of three corners, with the errors of points by their lane.
    struct Candidate
    {
        Lanes errors, squares;
        Plane plane;
        bool isProper;
        double error, sum; ///< of all lanes
    };

    struct Part ///< the best triangulation of corners i … k
    {
        double error, squares;
        int middle; ///< the third corner of the triangle at i–k; -1: none
    };

    Candidate& candidate(int i, int j, int k) { return _candidates[_base[i][j] + k]; }
    void take();
    void take(const PointLanes& points);

    /// Returns the triangle at an apex and a side, i to the next, not at the apex.
    Candidate& fanPiece(int apex, int i);

    int _count = 0, _apex = 0;
    std::array<Point, kMostCorners> _corners;
    std::array<Candidate, kMostPieces> _candidates;
    std::array<std::array<int, kMostCorners>, kMostCorners>
        _base; ///< so that base + k counts triples i < j < k
    std::array<std::array<Line, kMostCorners>, kMostCorners> _lines;
    std::array<std::array<Part, kMostCorners>, kMostCorners> _best;
    std::array<PointLanes, kMostPoints / kLanes> _blocks;
    std::size_t _points = 0, _taken = 0; ///< blocks whose points candidates have
};

} // namespace osgMultiTriangulation::core
