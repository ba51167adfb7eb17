// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace osgMultiTriangulation::core
{

/// Finds, among all triangulations of a hole, the one whose greatest vertical error at given points is least; of several, the one
/// with the least sum of squared errors.
/// The hole is the polygon that the star of a removed vertex leaves. Coordinates are relative to that vertex.
/// Use: setCorner() for each corner, begin(), add() for each point, solve().
/// Cost: O(m³) for m corners, and for each point O(m²) sides and the triangles that contain it.
/// Source: dynamic programming over the diagonals of a polygon, Klincsek, *Minimal triangulations of polygonal domains* (1980).
/// Differs: the weight of a triangulation is its greatest error, not a sum of lengths.
/// Threads: one; its memory is reused.
class HoleTriangulation
{
public:
    static constexpr int kMostCorners = 9;

    struct Point
    {
        double x, y, height;
    };

    /// A triangle by the numbers of its corners, rising, with its greatest error.
    struct Piece
    {
        std::uint8_t i, j, k;
        double error;
    };

    void setCorner(int i, const Point& corner) { _corners[i] = corner; }

    /// Starts over with the first `count` corners, counter-clockwise; 3 … kMostCorners. The polygon is simple.
    void begin(int count);

    /// Adds a point in the hole at which the surface is known.
    void add(const Point& point);

    /// Returns whether there is a triangulation at all (without triangles of no area).
    bool solve();

    /// The same among the fans: the triangulations whose triangles all have one corner. `isAtBorder`: only the first corner and the
    /// last may be that corner, as on a border, where the side between these two is to become the outline.
    bool solveFan(bool isAtBorder);

    /// Returns the corner that all triangles have, after solveFan().
    int apex() const { return _apex; }

    /// Returns the greatest error of the triangulation found.
    double error() const { return _best[0][_count - 1].error; }
    double squares() const { return _best[0][_count - 1].squares; }

    /// Returns the triangles found, `count - 2`.
    std::span<const Piece> pieces();
    std::span<const Piece> piecesOfFan();

private:
    static constexpr int kMostPieces = 84; ///< kMostCorners choose 3

    struct Candidate
    {
        double slopeX, slopeY, base; ///< the plane through its corners
        double error, squares;
        bool isProper;
    };

    struct Part ///< the best triangulation of corners i … k
    {
        double error, squares;
        int middle; ///< the third corner of the triangle at i–k; -1: none
    };

    Candidate& candidate(int i, int j, int k) { return _candidates[_base[i][j] + k]; }
    bool isLeft(int i, int j, const Point& p) const
    {
        const Point &a = _corners[i], &b = _corners[j];
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) >= 0.0;
    }

    /// Returns the triangle at an apex and a side, i to the next, not at the apex.
    Candidate& fanPiece(int apex, int i);

    int _count = 0, _apex = 0;
    std::array<Point, kMostCorners> _corners;
    std::array<Candidate, kMostPieces> _candidates;
    std::array<std::array<int, kMostCorners>, kMostCorners>
        _base; ///< so that base + k counts triples i < j < k
    std::array<std::array<Part, kMostCorners>, kMostCorners> _best;
    std::array<Piece, kMostCorners> _pieces;
};

} // namespace osgMultiTriangulation::core
