// SPDX-License-Identifier: Apache-2.0
#include "RotationOrbits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/PointGrid.h>

#include "PositionAt.h"

namespace osgPMObjects::core
{

namespace
{

constexpr std::uint32_t kLeastFold = 5;

glm::dvec3 turned(const glm::dvec3& place, int axis, const glm::dvec3& middle, double angle)
{
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const glm::dvec2 from(place[u] - middle[u], place[v] - middle[v]);
    glm::dvec3 image = place;
    image[u] = middle[u] + std::cos(angle) * from.x - std::sin(angle) * from.y;
    image[v] = middle[v] + std::sin(angle) * from.x + std::cos(angle) * from.y;
    return image;
}

double radiusOf(const glm::dvec3& place, int axis, const glm::dvec3& middle)
{
    glm::dvec3 from = place - middle;
    from[axis] = 0.0;
    return glm::length(from);
}

/// Returns how many positions are as far from the axis, and as far along it, as the one that is farthest from
/// it: the fold divides it.
std::uint32_t widestRing(std::span<const glm::dvec3> positions, int axis, const glm::dvec3& middle)
{
    const auto byRadius = [&](const glm::dvec3& a, const glm::dvec3& b)
    { return radiusOf(a, axis, middle) < radiusOf(b, axis, middle); };
    const glm::dvec3& widest = *std::max_element(positions.begin(), positions.end(), byRadius);
    const double radius = radiusOf(widest, axis, middle);
    return static_cast<std::uint32_t>(
        std::count_if(positions.begin(), positions.end(),
                      [&](const glm::dvec3& p)
                      {
                          return std::abs(p[axis] - widest[axis]) < kSamePlace &&
                                 std::abs(radiusOf(p, axis, middle) - radius) < kSamePlace;
                      }));
}

/// Finds the images; `next` stays empty where some position has none.
RotationOrbits orbitsAbout(int axis, const glm::dvec3& middle, std::uint32_t fold,
                           std::span<const glm::dvec3> positions, const PointGrid& grid)
{
    RotationOrbits orbits{axis, middle, fold, {}};
    const double angle = 2.0 * std::numbers::pi / fold;
    orbits.next.reserve(positions.size());
    for (const glm::dvec3& p : positions)
    {
        const std::uint32_t image = positionAt(turned(p, axis, middle, angle), positions, grid);
        if (image == RotationOrbits::kNone) return {};
        orbits.next.push_back(image);
    }
    return orbits;
}

bool mapsFaces(const RotationOrbits& orbits, std::span<const Triangle> sorted)
{
    return std::all_of(
        sorted.begin(), sorted.end(),
        [&](const Triangle& t)
        {
            const Triangle image = sortedCorners({orbits.next[t[0]], orbits.next[t[1]], orbits.next[t[2]]});
            return std::binary_search(sorted.begin(), sorted.end(), image);
        });
}

} // namespace

std::uint32_t RotationOrbits::imageOf(std::uint32_t position, std::uint32_t turns) const
{
    for (; turns > 0; --turns)
        position = next[position];
    return position;
}

glm::dvec3 RotationOrbits::imageOf(const glm::dvec3& place, std::uint32_t turns) const
{
    return turned(place, axis, middle, 2.0 * std::numbers::pi * turns / fold);
}

glm::dvec3 RotationOrbits::within(const glm::dvec3& place, double radius) const
{
    const double off = radiusOf(place, axis, middle);
    if (off <= radius) return place;
    glm::dvec3 near = middle + radius / off * (place - middle);
    near[axis] = place[axis];
    return near;
}

double RotationOrbits::radiusIn(const Extent& box) const
{
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    return std::min(
        {box.high[u] - middle[u], middle[u] - box.low[u], box.high[v] - middle[v], middle[v] - box.low[v]});
}

std::uint32_t RotationOrbits::stepFor(std::uint32_t from, std::uint32_t to) const
{
    std::uint32_t between = 0; // turns from `from` to `to`; 0: none
    std::uint32_t image = from;
    for (std::uint32_t turns = 1; turns < fold && between == 0; ++turns)
        if ((image = next[image]) == to) between = turns;
    if (between == 0) return step;
    for (std::uint32_t wider = step; wider < fold; wider += step)
        if (fold % wider == 0 && between % wider != 0) return wider;
    return 0;
}

RotationOrbits rotationOrbits(std::span<const glm::dvec3> positions, std::span<const Triangle> triangles)
{
    if (positions.size() < kLeastFold) return {};
    glm::dvec3 middle(0.0);
    for (const glm::dvec3& p : positions)
        middle += p / static_cast<double>(positions.size());
    const PointGrid grid = samePlaceGrid(positions);
    std::vector<Triangle> sorted;
    for (const Triangle& t : triangles)
        sorted.push_back(sortedCorners(t));
    std::sort(sorted.begin(), sorted.end());
    RotationOrbits best;
    for (int axis = 0; axis < 3; ++axis)
    {
        const std::uint32_t ring = widestRing(positions, axis, middle);
        for (std::uint32_t parts = 1; ring / parts >= std::max(kLeastFold, best.fold + 1); ++parts)
        {
            if (ring % parts != 0) continue;
            RotationOrbits orbits = orbitsAbout(axis, middle, ring / parts, positions, grid);
            if (orbits.next.empty() || !mapsFaces(orbits, sorted)) continue;
            best = std::move(orbits);
            break;
        }
    }
    return best;
}

} // namespace osgPMObjects::core
