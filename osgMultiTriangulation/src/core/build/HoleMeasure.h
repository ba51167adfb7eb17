// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "HoleTriangulation.h"

namespace osgMultiTriangulation::core
{

/// Measures one triangulation of a hole: in which triangle a point lies, and how far it is from there.
/// Cost: for each point some two sides of half of the triangles.
class HoleMeasure
{
public:
    using Point = HoleTriangulation::Point;

    /// Starts with the triangles of a hole. `corners`: those of the hole.
    void begin(std::span<const HoleTriangulation::Piece> pieces, std::span<const Point> corners);

    /// Takes a point into account. Returns the number of its triangle: the first that contains it, or the
    /// last.
    std::uint8_t measure(const Point& point);

    std::size_t pieces() const { return _count; }
    double greatest() const { return _greatest; } ///< error of all points measured, metres

    /// Returns the worst point of a triangle among those measured, and its error; below 0: it has none.
    const Point& worstOf(std::size_t piece) const { return _pieces[piece].worst; }
    double errorOf(std::size_t piece) const { return _pieces[piece].error; }

private:
    struct Measured
    {
        std::array<HoleTriangulation::Line, 3> sides;
        HoleTriangulation::Plane plane;
        double error;
        Point worst;

        bool contains(const Point& p) const
        {
            return sides[0].isLeft(p) && sides[1].isLeft(p) && sides[2].isLeft(p);
        }
    };

    std::size_t _count = 0;
    double _greatest = 0.0;
    std::array<Measured, HoleTriangulation::kMostCorners> _pieces;
};

} // namespace osgMultiTriangulation::core
