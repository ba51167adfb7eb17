// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osgPMObjects/core/tessellate/PolygonProjection.h>

namespace osgPMObjects::core
{

namespace
{

/// The share of the absolute area below which an area counts as cancelled out.
constexpr double kCancelled = 1e-9;
constexpr double kLeastCoordinate = 0x1p-200;

/// Scales corners to a size of at most 1; exact but for underflow.
std::vector<glm::dvec3> scaled(std::span<const glm::dvec3> corners)
{
    double largest = 0.0;
    for (const glm::dvec3& c : corners)
        largest = std::max({largest, std::abs(c.x), std::abs(c.y), std::abs(c.z)});
    int exponent = 0;
    std::frexp(largest, &exponent);
    std::vector<glm::dvec3> small;
    small.reserve(corners.size());
    for (const glm::dvec3& c : corners)
        small.emplace_back(std::ldexp(c.x, -exponent), std::ldexp(c.y, -exponent),
                           std::ldexp(c.z, -exponent));
    return small;
}

/// Returns by axis the sum of the absolute areas of the triangles from the first corner.
glm::dvec3 absoluteAreas(std::span<const glm::dvec3> contour)
{
    glm::dvec3 sum(0.0);
    for (std::size_t i = 2; i < contour.size(); ++i)
        sum += glm::abs(glm::cross(contour[i - 1] - contour[0], contour[i] - contour[0]));
    return sum;
}

int largestAxis(const glm::dvec3& vector)
{
    const glm::dvec3 size = glm::abs(vector);
    return size.z >= size.x && size.z >= size.y ? 2 : size.x >= size.y ? 0 : 1;
}

double normalZero(double coordinate)
{
    return std::abs(coordinate) < kLeastCoordinate ? 0.0 : coordinate;
}

/// Returns twice the area vector of the largest contour, and its absolute areas.
struct LargestContour
{
    glm::dvec3 area{0.0}, absolute{0.0};
};

LargestContour largestContour(std::span<const glm::dvec3> corners,
                              std::span<const std::uint32_t> contourSizes)
{
    LargestContour largest;
    std::size_t first = 0;
    for (const std::uint32_t size : contourSizes)
    {
        const auto contour = corners.subspan(first, size);
        first += size;
        const glm::dvec3 absolute = absoluteAreas(contour);
        if (glm::length(absolute) <= glm::length(largest.absolute)) continue;
        largest = {areaVector(contour), absolute};
    }
    return largest;
}

} // namespace

glm::dvec3 areaVector(std::span<const glm::dvec3> contour)
{
    glm::dvec3 sum(0.0);
    for (std::size_t i = 2; i < contour.size(); ++i)
        sum += glm::cross(contour[i - 1] - contour[0], contour[i] - contour[0]);
    return sum;
}

std::vector<glm::dvec2> projectPolygon(std::span<const glm::dvec3> corners,
                                       std::span<const std::uint32_t> contourSizes, ProjectionRule rule)
{
    const std::vector<glm::dvec3> small = scaled(corners);
    const LargestContour largest = largestContour(small, contourSizes);
    const bool isCancelled = glm::length(largest.area) <= kCancelled * glm::length(largest.absolute);
    std::vector<glm::dvec2> plane;
    plane.reserve(small.size());
    const auto add = [&](double x, double y) { plane.emplace_back(normalZero(x), normalZero(y)); };
    if (rule == ProjectionRule::averageNormal && !isCancelled)
    {
        const glm::dvec3 normal = glm::normalize(largest.area);
        glm::dvec3 across(0.0);
        across[(largestAxis(normal) + 1) % 3] = 1.0;
        const glm::dvec3 y = glm::normalize(glm::cross(normal, across)), x = glm::cross(y, normal);
        for (const glm::dvec3& c : small) // halved, for a diagonal can be √3 long
            add(0.5 * glm::dot(x, c), 0.5 * glm::dot(y, c));
        return plane;
    }
    const int dropped = largestAxis(isCancelled ? largest.absolute : largest.area);
    const bool isSwapped = largest.area[dropped] < 0.0;
    const int x = (dropped + (isSwapped ? 2 : 1)) % 3, y = (dropped + (isSwapped ? 1 : 2)) % 3;
    for (const glm::dvec3& c : small)
        add(c[x], c[y]);
    return plane;
}

} // namespace osgPMObjects::core
