// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace osgPMObjects::core
{

/// A triangle in the plane, counter-clockwise.
using FlatTriangle = std::array<glm::dvec2, 3>;

/// Returns twice the area of a triangle, negative for a clockwise one.
inline double doubleArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether two triangles share more than their borders: no side of either has the other outside. An overlap
/// thinner than `tolerance` does not count. Units: as the corners.
bool overlap(const FlatTriangle& a, const FlatTriangle& b, double tolerance);

/// A set of triangles in the plane that do not overlap, in a grid of squares.
class FlatFaces
{
public:
    /// For about `expected` triangles in a box; triangles outside of it are found more slowly.
    FlatFaces(const glm::dvec2& low, const glm::dvec2& high, std::size_t expected);

    /// Adds a triangle, unless it is clockwise or overlaps another. Returns whether it was added.
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
    int _side; ///< number of cells
    std::vector<std::vector<std::uint32_t>> _cells;
    std::vector<FlatTriangle> _triangles;
};

} // namespace osgPMObjects::core
