// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace osgPMObjects::core
{

/// A triangle in a plane, counter-clockwise.
using FlatTriangle = std::array<glm::dvec2, 3>;

/// Twice the area of a triangle, below 0 where it is clockwise.
inline double doubleArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether two triangles share more than their borders: no side of either has the other outside. What is thinner than
/// `tolerance` does not count. Units: as the corners.
bool overlap(const FlatTriangle& a, const FlatTriangle& b, double tolerance);

/// Triangles of a plane that do not overlap, in a grid of squares.
class FlatFaces
{
public:
    /// For about `expected` triangles in a box; those outside are found, too, only not as fast.
    FlatFaces(const glm::dvec2& low, const glm::dvec2& high, std::size_t expected);

    /// Adds a triangle unless it would overlap another or is clockwise; tells whether it did.
    bool add(const FlatTriangle& triangle);

private:
    struct Cells
    {
        int left, right, bottom, top;
    };

    Cells cellsOf(const FlatTriangle& triangle) const;
    bool isFree(const FlatTriangle& triangle, const Cells& cells) const;

    glm::dvec2 _low;
    glm::dvec2 _cellsPerUnit;
    double _tolerance;
    int _side; ///< cells
    std::vector<std::vector<std::uint32_t>> _cells;
    std::vector<FlatTriangle> _triangles;
};

} // namespace osgPMObjects::core
