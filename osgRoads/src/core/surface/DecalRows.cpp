// SPDX-License-Identifier: Apache-2.0
#include "DecalRows.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "JunctionCover.h"

namespace osgRoads::core
{

namespace
{

constexpr std::size_t kMostInList = 200;
/// Origins of lists lie on this grid: whole numbers that floats hold exactly.
constexpr double kListGridM = 64.0;

using Corners = std::array<glm::dvec2, 4>;

/// Whether a side of `a` has all of `b` on its outer side.
bool isApart(const Corners& a, const Corners& b)
{
    const glm::dvec2 middle = 0.25 * (a[0] + a[1] + a[2] + a[3]);
    for (std::size_t i = 0; i < 4; ++i)
    {
        const glm::dvec2 side = a[(i + 1) % 4] - a[i];
        const auto sideOf = [&](glm::dvec2 p) { return side.x * (p.y - a[i].y) - side.y * (p.x - a[i].x); };
        const double inner = sideOf(middle);
        if (std::fabs(inner) < 1e-12) continue;
        if (std::all_of(b.begin(), b.end(), [&](glm::dvec2 p) { return sideOf(p) * inner < 0.0; }))
            return true;
    }
    return false;
}

DecalRow rowOf(const Decal& decal, glm::dvec2 origin)
{
    const auto f = [](double value) { return static_cast<float>(value); };
    const glm::dvec2 start = glm::dvec2(decal.start) - origin;
    return {f(start.x),
            f(start.y),
            f(decal.along.x),
            f(decal.along.y),
            f(decal.length),
            f(0.5 * decal.widthStart),
            f(0.5 * decal.widthEnd),
            f(decal.shift),
            f(decal.dash),
            f(decal.period),
            f(decal.phase),
            0.0F,
            decal.paint.x,
            decal.paint.y,
            decal.paint.z,
            0.0F};
}

} // namespace

DecalFinder::DecalFinder(const PlacedNetwork& network) : _decals(roadDecals(network))
{
    std::vector<PlanBox> boxes(_decals.size());
    for (std::size_t i = 0; i < _decals.size(); ++i)
        for (const glm::dvec2& corner : _decals[i].corners())
            boxes[i].include(corner);
    if (!boxes.empty()) _tree = BoxTree(boxes);
}

std::vector<std::uint32_t> DecalFinder::on(std::span<const SurfaceQuad> quads) const
{
    std::vector<std::uint32_t> found;
    if (_tree.isEmpty()) return found;
    for (const SurfaceQuad& quad : quads)
    {
        const Corners plan{glm::dvec2(quad[0]), glm::dvec2(quad[1]), glm::dvec2(quad[2]),
                           glm::dvec2(quad[3])};
        const glm::dvec3 middle = 0.25 * (quad[0] + quad[1] + quad[2] + quad[3]);
        double square = 0.0;
        for (const glm::dvec3& corner : quad)
            square = std::max(square, glm::dot(glm::dvec2(corner - middle), glm::dvec2(corner - middle)));
        const double rise = std::fabs(quad[0].z - quad[2].z);
        _tree.search(glm::dvec2(middle), square,
                     [&](std::uint32_t i, double limit)
                     {
                         const Corners corners = _decals[i].corners();
                         if (std::fabs(_decals[i].start.z - middle.z) < kSameLevelM + rise &&
                             !isApart(plan, corners) && !isApart(corners, plan))
                             found.push_back(i);
                         return limit;
                     });
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

std::uint32_t DecalRows::listFor(std::span<const SurfaceQuad> quads)
{
    std::vector<std::uint32_t> found = _finder.on(quads);
    if (found.empty()) return 0;
    found.resize(std::min(found.size(), kMostInList));
    // The origin of a list lies near its first quad.
    const glm::dvec2 cell = glm::round(glm::dvec2(quads.front()[0] - _origin) / kListGridM);
    const auto row = static_cast<std::uint32_t>(_rows.size());
    _rows.push_back(
        {static_cast<float>(cell.x), static_cast<float>(cell.y), static_cast<float>(found.size())});
    for (const std::uint32_t i : found)
        _rows.push_back(rowOf(_finder.decals()[i], glm::dvec2(_origin) + kListGridM * cell));
    return row;
}

} // namespace osgRoads::core
