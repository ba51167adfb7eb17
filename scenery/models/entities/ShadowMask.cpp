// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/entities/ShadowMask.h"

#include <algorithm>
#include <cmath>

namespace scenery::models
{

namespace
{

constexpr double kSunWidthRad = 0.0093;
constexpr int kCellsOfMask = ShadowMask::kCells;

using Corners = std::array<glm::dvec2, 3>;

/// All triangles of the model, cast onto the plane.
std::vector<Corners> castTriangles(const EntityModel& model, const std::vector<glm::dmat4>& pose,
                                   const ShadowView& view)
{
    const glm::dvec2 slide = glm::dvec2(view.sun) / view.sun.z;
    std::vector<Corners> cast;
    for (std::size_t part = 0; part < model.parts.size(); ++part)
    {
        const auto& mesh = model.meshes[model.parts[part]].mesh;
        std::vector<glm::dvec2> places;
        for (const glm::dvec3& p : mesh.positions)
        {
            const glm::dvec3 at = view.planeFromBody * glm::dvec3(pose[part] * glm::dvec4(p, 1.0));
            places.push_back(glm::dvec2(at) - (at.z + view.heightM) * slide);
        }
        for (const auto& face : mesh.faces)
            cast.push_back({places[mesh.positionOf(face, 0)], places[mesh.positionOf(face, 1)],
                            places[mesh.positionOf(face, 2)]});
    }
    return cast;
}

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

/// Covers the cells whose middle is in a triangle. Units: cells.
void coverCells(std::vector<std::uint8_t>& cover, Corners c)
{
    if (cross(c[1] - c[0], c[2] - c[0]) < 0.0) std::swap(c[1], c[2]);
    const auto cell = [](double v)
    { return std::clamp(static_cast<int>(std::floor(v)), 0, kCellsOfMask - 1); };
    const glm::dvec2 least = glm::min(c[0], glm::min(c[1], c[2])),
                     most = glm::max(c[0], glm::max(c[1], c[2]));
    for (int y = cell(least.y); y <= cell(most.y); ++y)
        for (int x = cell(least.x); x <= cell(most.x); ++x)
        {
            const glm::dvec2 at(x + 0.5, y + 0.5);
            bool isIn = true;
            for (std::size_t i = 0; i < 3; ++i)
                isIn = isIn && cross(c[(i + 1) % 3] - c[i], at - c[i]) >= 0.0;
            if (isIn) cover[static_cast<std::size_t>(y * kCellsOfMask + x)] = 255;
        }
}

/// Means over 2 r + 1 cells along one axis.
void blurAlong(std::vector<std::uint8_t>& cover, int radius, int step, int across)
{
    std::vector<int> line(kCellsOfMask);
    for (int row = 0; row < kCellsOfMask; ++row)
    {
        const auto at = [&](int i) -> std::uint8_t&
        { return cover[static_cast<std::size_t>(row * across + i * step)]; };
        int sum = 0;
        for (int i = -radius; i < kCellsOfMask + radius; ++i)
        {
            if (i + radius < kCellsOfMask) sum += at(i + radius);
            if (i >= 0 && i < kCellsOfMask) line[static_cast<std::size_t>(i)] = sum / (2 * radius + 1);
            if (i - radius >= 0 && i - radius < kCellsOfMask) sum -= at(i - radius);
        }
        for (int i = 0; i < kCellsOfMask; ++i)
            at(i) = static_cast<std::uint8_t>(line[static_cast<std::size_t>(i)]);
    }
}

} // namespace

double ShadowMask::at(const glm::dvec2& place) const
{
    const glm::dvec2 share = (place - low) / (high - low) * static_cast<double>(kCells);
    if (cover.empty() || !(std::min(share.x, share.y) >= 0.0 && std::max(share.x, share.y) < kCells))
        return 0.0;
    return cover[static_cast<std::size_t>(share.y) * kCells + static_cast<std::size_t>(share.x)] / 255.0;
}

ShadowMask castShadow(const EntityModel& model, const std::vector<glm::dmat4>& pose, const ShadowView& view)
{
    constexpr double kSharpestM = 0.04;
    ShadowMask mask{glm::dvec2(1e300), glm::dvec2(-1e300), {}};
    std::vector<Corners> triangles = castTriangles(model, pose, view);
    for (const Corners& corners : triangles)
        for (const glm::dvec2& corner : corners)
        {
            mask.low = glm::min(mask.low, corner);
            mask.high = glm::max(mask.high, corner);
        }
    if (triangles.empty()) return {};
    const double softM = kSharpestM + kSunWidthRad * std::max(view.heightM, 0.0) / view.sun.z;
    const double half =
        0.5 * std::max(mask.high.x - mask.low.x, mask.high.y - mask.low.y) + 1.5 * softM + 0.02;
    const glm::dvec2 middle = 0.5 * (mask.low + mask.high);
    mask.low = middle - half;
    mask.high = middle + half;
    mask.cover.assign(static_cast<std::size_t>(kCellsOfMask) * kCellsOfMask, 0);
    const double cellM = 2.0 * half / kCellsOfMask;
    for (Corners& corners : triangles)
    {
        for (glm::dvec2& corner : corners)
            corner = (corner - mask.low) / cellM;
        coverCells(mask.cover, corners);
    }
    const int radius = std::clamp(static_cast<int>(std::lround(0.5 * softM / cellM)), 1, kCellsOfMask / 3);
    for (int pass = 0; pass < 2; ++pass)
    {
        blurAlong(mask.cover, radius, 1, kCellsOfMask);
        blurAlong(mask.cover, radius, kCellsOfMask, 1);
    }
    return mask;
}

} // namespace scenery::models
