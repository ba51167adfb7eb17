// SPDX-License-Identifier: Apache-2.0
#include "Visibility.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

namespace osgPMObjects::core
{

namespace
{

/// Returns the i-th number, 0 to 1, of an evenly spread sequence. Source: van der Corput,
/// *Verteilungsfunktionen* (1935), base `base`.
double spread(int i, int base)
{
    double value = 0.0, digit = 1.0;
    for (; i > 0; i /= base)
    {
        digit /= base;
        value += digit * (i % base);
    }
    return value;
}

/// Returns a direction before a unit normal, from two numbers 0 to 1; directions near the normal are more
/// frequent.
glm::dvec3 directionBefore(const glm::dvec3& normal, double u, double v)
{
    const double radius = std::sqrt(u), angle = 6.283185307179586 * v;
    const glm::dvec3 other = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 s = glm::normalize(glm::cross(normal, other)), t = glm::cross(normal, s);
    return radius * std::cos(angle) * s + radius * std::sin(angle) * t +
           std::sqrt(std::max(1e-4, 1.0 - u)) * normal;
}

} // namespace

Openness openness(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles,
                  std::span<const std::uint32_t> patch, const TriangleTree& tree, int rays,
                  std::uint64_t boxesARay)
{
    const auto areaVector = [&](std::uint32_t f)
    {
        const Triangle& t = triangles[f];
        return glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
    };
    std::vector<double> areas; // cumulative
    for (const std::uint32_t f : patch)
        areas.push_back((areas.empty() ? 0.0 : areas.back()) + glm::length(areaVector(f)));
    if (!(areas.back() > 0.0)) return {};
    int front = 0, back = 0;
    std::uint64_t work = boxesARay * 2 * static_cast<std::uint64_t>(rays);
    Openness found;
    for (int i = 0; i < rays; ++i)
    {
        const auto chosen = std::lower_bound(areas.begin(), areas.end(), areas.back() * (i + 0.5) / rays);
        const std::uint32_t f =
            patch[static_cast<std::size_t>(std::min(chosen, areas.end() - 1) - areas.begin())];
        const glm::dvec3 vector = areaVector(f);
        const double length = glm::length(vector);
        if (!(length > 0.0)) continue;
        double u = spread(i + 1, 2), v = spread(i + 1, 3);
        if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
        const Triangle& t = triangles[f];
        const glm::dvec3 from = positions[t[0]] + u * (positions[t[1]] - positions[t[0]]) +
                                v * (positions[t[2]] - positions[t[0]]);
        const glm::dvec3 direction = directionBefore(vector / length, spread(i + 1, 5), spread(i + 1, 7));
        const double least = 1e-6 * std::sqrt(length); // starts beyond its own face
        const auto hitBefore = tree.isHit(from, direction, least, work),
                   hitBehind = tree.isHit(from, -direction, least, work);
        found.isCutShort = !hitBefore || !hitBehind;
        if (found.isCutShort) break;
        front += !*hitBefore;
        back += !*hitBehind;
    }
    if (front + back > 0) found.value = static_cast<double>(front - back) / (front + back);
    return found;
}

} // namespace osgPMObjects::core
