// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgPMObjects/core/simplify/ContourTriangulation.h>
#include <osgPMObjects/core/tessellate/Orientation.h>

namespace osgPMObjects::core
{

namespace
{

/// A contour with a tolerance relative to its size.
class Contour
{
public:
    explicit Contour(std::span<const glm::dvec2> corners) : _corners(corners)
    {
        glm::dvec2 low = corners[0], high = corners[0];
        for (const glm::dvec2& corner : corners)
        {
            low = glm::min(low, corner);
            high = glm::max(high, corner);
        }
        _flat = kContourFlatness * glm::dot(high - low, high - low);
    }

    std::uint32_t size() const { return static_cast<std::uint32_t>(_corners.size()); }
    std::uint32_t after(std::uint32_t i) const { return i + 1 < size() ? i + 1 : 0; }
    const glm::dvec2& operator[](std::uint32_t i) const { return _corners[i]; }

    /// Returns 1 when c lies left of a→b, -1: right, 0: on it within the tolerance.
    int side(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
    {
        const double twiceArea = orientation(_corners[a], _corners[b], _corners[c]);
        return twiceArea > _flat ? 1 : twiceArea < -_flat ? -1 : 0;
    }

    /// Whether two segments without a common end intersect or touch.
    bool meet(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const
    {
        const int ca = side(a, b, c), da = side(a, b, d), ac = side(c, d, a), bc = side(c, d, b);
        if (ca * da < 0 && ac * bc < 0) return true;
        return isOn(a, b, c) || isOn(a, b, d) || isOn(c, d, a) || isOn(c, d, b);
    }

    /// Whether c lies on the segment from a to b.
    bool isOn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
    {
        return side(a, b, c) == 0 && isBetween(a, b, c);
    }

    /// Whether the edges at b coincide and run in opposite directions.
    bool isSpike(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
    {
        return side(a, b, c) == 0 && glm::dot(_corners[a] - _corners[b], _corners[c] - _corners[b]) >= 0.0;
    }

    double twiceArea() const
    {
        double sum = 0.0;
        for (std::uint32_t i = 0; i < size(); ++i)
        {
            const glm::dvec2 a = _corners[i] - _corners[0], b = _corners[after(i)] - _corners[0];
            sum += a.x * b.y - a.y * b.x;
        }
        return sum;
    }

    double flat() const { return _flat; }

private:
    /// For a point on the line through a and b: whether it is between them, or at one of them.
    bool isBetween(std::uint32_t a, std::uint32_t b, std::uint32_t point) const
    {
        return glm::dot(_corners[a] - _corners[point], _corners[b] - _corners[point]) <= 0.0;
    }

    std::span<const glm::dvec2> _corners;
    double _flat = 0.0;
};

bool isSimple(const Contour& contour)
{
    if (!(contour.twiceArea() > contour.flat())) return false;
    const std::uint32_t n = contour.size();
    for (std::uint32_t i = 0; i < n; ++i)
    {
        const std::uint32_t j = contour.after(i);
        if (contour.isSpike(i, j, contour.after(j))) return false;
        for (std::uint32_t k = i + 2; k < n; ++k)
            if (contour.after(k) != i && contour.meet(i, j, k, contour.after(k))) return false;
    }
    return true;
}

/// Whether two corners see each other, within the part of the contour from corner `first` to `last`, closed
/// by a line.
bool isSeen(const Contour& contour, std::uint32_t first, std::uint32_t last, std::uint32_t from,
            std::uint32_t to)
{
    for (std::uint32_t i = first; i < last; ++i)
    {
        if (i == from || i == to) continue;
        if (contour.isOn(from, to, i)) return false;
        if (i + 1 != from && i + 1 != to && contour.meet(from, to, i, i + 1)) return false;
    }
    return true;
}

/// Returns the corner between `first` and `last` that makes the triangle on their line; `last` if there is
/// none.
std::uint32_t apexOn(const Contour& contour, std::uint32_t first, std::uint32_t last)
{
    std::uint32_t best = last;
    double leastCotangent = std::numeric_limits<double>::infinity();
    for (std::uint32_t p = first + 1; p < last; ++p)
    {
        if (contour.side(last, first, p) <= 0) continue;
        const glm::dvec2 a = contour[last] - contour[p], b = contour[first] - contour[p];
        const double cotangent = glm::dot(a, b) / (a.x * b.y - a.y * b.x);
        if (!(cotangent < leastCotangent)) continue;
        if (p != first + 1 && !isSeen(contour, first, last, first, p)) continue;
        if (p != last - 1 && !isSeen(contour, first, last, p, last)) continue;
        best = p;
        leastCotangent = cotangent;
    }
    return best;
}

} // namespace

bool isSimpleContour(std::span<const glm::dvec2> contour)
{
    return contour.size() >= 3 && isSimple(Contour(contour));
}

bool triangulateContour(std::span<const glm::dvec2> corners, std::vector<Triangle>& triangles)
{
    if (corners.size() < 3 || corners.size() > kMostContourCorners) return false;
    const Contour contour(corners);
    if (!isSimple(contour)) return false;
    const std::size_t before = triangles.size();
    std::vector<std::pair<std::uint32_t, std::uint32_t>> baseLines = {{0, contour.size() - 1}};
    while (!baseLines.empty())
    {
        const auto [first, last] = baseLines.back();
        baseLines.pop_back();
        if (last - first < 2) continue; // a side of the contour
        const std::uint32_t apex = apexOn(contour, first, last);
        if (apex == last)
        {
            triangles.resize(before);
            return false;
        }
        triangles.push_back({first, apex, last});
        baseLines.emplace_back(apex, last);
        baseLines.emplace_back(first, apex);
    }
    return true;
}

} // namespace osgPMObjects::core
