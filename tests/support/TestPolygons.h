// SPDX-License-Identifier: Apache-2.0
// Polygons for tests, and what must hold of their triangles, worked out without the code under test.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/glm.hpp>

#include "Random.h"

namespace testsupport
{

struct Polygon
{
    std::vector<glm::dvec2> corners;
    std::vector<std::uint32_t> contourSizes;

    void add(const std::vector<glm::dvec2>& contour)
    {
        corners.insert(corners.end(), contour.begin(), contour.end());
        contourSizes.push_back(static_cast<std::uint32_t>(contour.size()));
    }

    std::vector<glm::dvec3> inSpace() const
    {
        std::vector<glm::dvec3> flat;
        for (const glm::dvec2& c : corners)
            flat.emplace_back(c, 0.0);
        return flat;
    }

    /// Calls `visit(from, to)` for each edge.
    template<class F>
    void forEachEdge(F visit) const
    {
        std::size_t first = 0;
        for (const std::uint32_t size : contourSizes)
        {
            for (std::uint32_t i = 0; i < size; ++i)
                visit(corners[first + i], corners[first + (i + 1) % size]);
            first += size;
        }
    }
};

/// Concave, around a centre, radii between a third of `radius` and all of it.
inline std::vector<glm::dvec2> star(Random& random, const glm::dvec2& centre, double radius,
                                    std::uint32_t corners)
{
    std::vector<glm::dvec2> contour;
    for (std::uint32_t i = 0; i < corners; ++i)
    {
        const double angle = 2.0 * std::numbers::pi * (i + 0.9 * random.unit()) / corners;
        const double reach = radius * (1.0 + 2.0 * random.unit()) / 3.0;
        contour.push_back(centre + reach * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return contour;
}

/// A star with up to eight holes, in any direction, that neither touch it nor one another.
inline Polygon starWithHoles(Random& random)
{
    Polygon polygon;
    polygon.add(star(random, {0.0, 0.0}, 100.0, 8 + random.below(25)));
    const std::uint32_t holes = random.below(9);
    for (std::uint32_t i = 0; i < holes; ++i)
    { // within the circle that every star of that radius contains, each in a cell of its own
        const glm::dvec2 centre(-10.0 + 10.0 * (i % 3), -10.0 + 10.0 * (i / 3));
        auto hole = star(random, centre, 4.9, 3 + random.below(8));
        if (random.below(2) == 0) std::reverse(hole.begin(), hole.end());
        polygon.add(hole);
    }
    return polygon;
}

/// Corners on a small grid: edges cross, touch and overlap, corners coincide, contours have no area.
inline Polygon tangle(Random& random)
{
    Polygon polygon;
    const std::uint32_t contours = 1 + random.below(3), cells = 2 + random.below(7);
    for (std::uint32_t k = 0; k < contours; ++k)
    {
        std::vector<glm::dvec2> contour(1 + random.below(12));
        for (glm::dvec2& corner : contour)
            corner = {random.below(cells), random.below(cells)};
        polygon.add(contour);
    }
    return polygon;
}

/// How often the contours run around a place that lies on none of them.
inline int windingNumber(const Polygon& polygon, const glm::dvec2& place)
{
    int number = 0;
    polygon.forEachEdge(
        [&](const glm::dvec2& a, const glm::dvec2& b)
        {
            if ((a.y > place.y) == (b.y > place.y)) return;
            const double x = a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y);
            if (x > place.x) number += b.y > a.y ? 1 : -1;
        });
    return number;
}

/// The area of all places whose winding number is `wanted`, by cutting the plane into strips in which no
/// edges meet.
template<class Wanted>
double areaWhere(const Polygon& polygon, Wanted wanted)
{
    std::vector<std::pair<glm::dvec2, glm::dvec2>> edges;
    std::vector<double> cuts;
    polygon.forEachEdge(
        [&](const glm::dvec2& a, const glm::dvec2& b)
        {
            edges.emplace_back(a, b);
            cuts.push_back(a.y);
        });
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
        {
            const auto& [a, b] = edges[i];
            const auto& [c, d] = edges[j];
            const glm::dvec2 u = b - a, v = d - c, w = c - a;
            const double determinant = u.x * v.y - u.y * v.x;
            if (determinant == 0.0) continue;
            const double share = (w.x * v.y - w.y * v.x) / determinant;
            if (share > 0.0 && share < 1.0) cuts.push_back(a.y + share * u.y);
        }
    std::sort(cuts.begin(), cuts.end());
    double area = 0.0;
    for (std::size_t i = 1; i < cuts.size(); ++i)
    {
        const double height = cuts[i] - cuts[i - 1], y = 0.5 * (cuts[i] + cuts[i - 1]);
        if (height <= 0.0) continue;
        std::vector<std::pair<double, int>> hits;
        for (const auto& [a, b] : edges)
            if ((a.y > y) != (b.y > y))
                hits.emplace_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y), b.y > a.y ? 1 : -1);
        std::sort(hits.begin(), hits.end());
        int number =
            0; // of what lies left of the hit, seen from the left: the other way round, but counted alike
        for (std::size_t k = 0; k + 1 < hits.size(); ++k)
        {
            number -= hits[k].second;
            if (wanted(number)) area += height * (hits[k + 1].first - hits[k].first);
        }
    }
    return area;
}

inline double oddArea(const Polygon& polygon)
{
    return areaWhere(polygon, [](int number) { return number % 2 != 0; });
}

} // namespace testsupport
