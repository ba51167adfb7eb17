// SPDX-License-Identifier: Apache-2.0
#include "HoleMeasure.h"

#include <algorithm>

namespace osgMultiTriangulation::core
{

void HoleMeasure::begin(std::span<const HoleTriangulation::Piece> pieces, std::span<const Point> corners)
{
    _count = pieces.size();
    _greatest = 0.0;
    for (std::size_t p = 0; p < _count; ++p)
    {
        const Point &a = corners[pieces[p].i], &b = corners[pieces[p].j], &c = corners[pieces[p].k];
        _pieces[p].sides = {HoleTriangulation::lineOf(a, b), HoleTriangulation::lineOf(b, c),
                            HoleTriangulation::lineOf(c, a)};
        _pieces[p].plane = HoleTriangulation::planeOf(a, b, c);
        _pieces[p].error = -1.0;
    }
}

std::uint8_t HoleMeasure::measure(const Point& point)
{
    std::size_t p = 0;
    while (p + 1 < _count && !_pieces[p].contains(point))
        ++p;
    Measured& piece = _pieces[p];
    const double error = piece.plane.distance(point);
    if (error > piece.error)
    {
        piece.error = error;
        piece.worst = point;
        _greatest = std::max(_greatest, error);
    }
    return static_cast<std::uint8_t>(p);
}

} // namespace osgMultiTriangulation::core
