// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include <osgMultiTriangulation/core/check/SurfaceCheck.h>

namespace osgMultiTriangulation::core
{

namespace
{

std::uint64_t keyOf(std::uint32_t from, std::uint32_t to)
{
    return std::uint64_t(from) << 32 | to;
}

std::string nameOf(const SurfaceMesh& mesh, std::size_t triangle)
{
    std::string name = "triangle " + std::to_string(triangle);
    for (const std::uint32_t corner : mesh.triangles[triangle])
        if (corner < mesh.points.size())
            name += " (" + std::to_string(mesh.points[corner].x) + ", " +
                    std::to_string(mesh.points[corner].y) + ")";
    return name;
}

/// The sides that no other triangle has in the opposite direction, as pairs of points, sorted.
std::vector<std::uint64_t> openSides(const SurfaceMesh& mesh)
{
    std::vector<std::uint64_t> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
        for (int c = 0; c < 3; ++c)
            sides.push_back(keyOf(t[c], t[(c + 1) % 3]));
    std::ranges::sort(sides);
    std::vector<std::uint64_t> open;
    for (const std::uint64_t side : sides)
        if (!std::ranges::binary_search(sides, side << 32 | side >> 32)) open.push_back(side);
    return open;
}

/// Whether a triangulation's numbers and areas are right, side by side.
std::optional<std::string> checkTriangles(const SurfaceMesh& mesh)
{
    std::vector<std::uint64_t> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
        const Triangle& corners = mesh.triangles[t];
        for (int c = 0; c < 3; ++c)
        {
            if (corners[c] >= mesh.points.size()) return nameOf(mesh, t) + " has a corner that is no point";
            sides.push_back(keyOf(corners[c], corners[(c + 1) % 3]));
        }
        if (!(twiceArea(mesh.points[corners[0]], mesh.points[corners[1]], mesh.points[corners[2]]) > 0.0))
            return nameOf(mesh, t) + " has no area or is clockwise";
    }
    std::ranges::sort(sides);
    if (const auto twice = std::ranges::adjacent_find(sides); twice != sides.end())
    {
        const SurfacePoint& from = mesh.points[*twice >> 32];
        return "two triangles have the same side at (" + std::to_string(from.x) + ", " +
               std::to_string(from.y) + ")";
    }
    return std::nullopt;
}

} // namespace

std::vector<OutlineSide> outlineOf(const SurfaceMesh& mesh)
{
    const std::vector<std::uint64_t> open = openSides(mesh);
    std::unordered_map<std::uint32_t, std::uint32_t> next,
        uses; // by point: where its side leads, how many begin there
    for (const std::uint64_t side : open)
    {
        next[static_cast<std::uint32_t>(side >> 32)] = static_cast<std::uint32_t>(side);
        ++uses[static_cast<std::uint32_t>(side >> 32)];
    }
    std::unordered_map<std::uint32_t, std::uint32_t> before;
    for (const std::uint64_t side : open)
        before[static_cast<std::uint32_t>(side)] = static_cast<std::uint32_t>(side >> 32);
    const auto isStraight =
        [&](std::uint32_t p) // the outline goes on straight, and touches itself nowhere here
    {
        const auto to = next.find(p), from = before.find(p);
        if (to == next.end() || from == before.end() || uses[p] != 1) return false;
        const SurfacePoint &a = mesh.points[from->second], &b = mesh.points[p], &c = mesh.points[to->second];
        const double along =
            (double(b.x) - a.x) * (double(c.x) - b.x) + (double(b.y) - a.y) * (double(c.y) - b.y);
        return twiceArea(a, b, c) == 0.0 && along > 0.0;
    };
    std::vector<OutlineSide> outline;
    for (const std::uint64_t side : open)
    {
        const auto from = static_cast<std::uint32_t>(side >> 32);
        if (isStraight(from)) continue;
        auto to = static_cast<std::uint32_t>(side);
        for (std::size_t steps = 0; isStraight(to) && steps < open.size(); ++steps)
            to = next[to];
        const SurfacePoint &a = mesh.points[from], &b = mesh.points[to];
        outline.push_back({a.x, a.y, b.x, b.y});
    }
    std::ranges::sort(outline);
    return outline;
}

std::optional<std::string> checkSurface(const SurfaceMesh& mesh, std::span<const OutlineSide> outline)
{
    if (auto fault = checkTriangles(mesh)) return fault;
    const std::vector<OutlineSide> own = outlineOf(mesh);
    if (std::ranges::equal(own, outline)) return std::nullopt;
    const auto [mine, other] = std::ranges::mismatch(own, outline);
    const OutlineSide& side = mine != own.end() ? *mine : *other;
    return "crack, T-junction or hole: the outline differs at (" + std::to_string(side[0]) + ", " +
           std::to_string(side[1]) + ")";
}

std::optional<std::string> checkInput(const SurfaceMesh& mesh)
{
    for (const SurfacePoint& p : mesh.points)
        if (p.x < 0 || p.y < 0 || p.x > kMostPlan || p.y > kMostPlan || !std::isfinite(p.height))
            return "the point (" + std::to_string(p.x) + ", " + std::to_string(p.y) +
                   ") is beyond the lattice or has no height";
    if (mesh.triangles.empty()) return "there is no triangle";
    return checkTriangles(mesh);
}

} // namespace osgMultiTriangulation::core
