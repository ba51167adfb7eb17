// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <random>
#include <thread>
#include <vector>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/SurfaceChange.h>
#include <osgPMObjects/core/mesh/TriangleTree.h>

namespace osgPMObjects::core
{

namespace
{

constexpr std::size_t kLeastShare = 2048;

/// The faces of a mesh that are a surface.
struct Surface
{
    const Mesh& mesh;
    std::vector<Triangle> triangles;

    explicit Surface(const Mesh& m) : mesh(m), triangles(positionTriangles(m))
    {
        const double height = kDegenerateHeight * diagonalOf(m);
        std::erase_if(triangles, [&](const Triangle& t)
                      { return repeatsCorner(t) || heightOf(at(t, 0), at(t, 1), at(t, 2)) <= height; });
    }

    const glm::dvec3& at(const Triangle& t, std::size_t corner) const { return mesh.positions[t[corner]]; }
};

/// Corners and centres.
std::vector<glm::dvec3> fixedSamples(const Surface& surface)
{
    std::vector<glm::dvec3> samples;
    std::vector<bool> isUsed(surface.mesh.positions.size(), false);
    for (const Triangle& t : surface.triangles)
    {
        samples.push_back((surface.at(t, 0) + surface.at(t, 1) + surface.at(t, 2)) / 3.0);
        for (const std::uint32_t p : t)
            isUsed[p] = true;
    }
    for (std::size_t p = 0; p < isUsed.size(); ++p)
        if (isUsed[p]) samples.push_back(surface.mesh.positions[p]);
    return samples;
}

std::vector<glm::dvec3> spreadSamples(const Surface& surface, std::size_t count)
{
    std::vector<double> areas; // summed up
    for (const Triangle& t : surface.triangles)
        areas.push_back((areas.empty() ? 0.0 : areas.back()) +
                        glm::length(glm::cross(surface.at(t, 1) - surface.at(t, 0),
                                               surface.at(t, 2) - surface.at(t, 0))));
    std::vector<glm::dvec3> samples;
    std::mt19937_64 random(1);
    const auto next = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    for (std::size_t i = 0; i < count && !areas.empty(); ++i)
    {
        const auto chosen = std::lower_bound(areas.begin(), areas.end() - 1, areas.back() * next());
        const Triangle& t = surface.triangles[static_cast<std::size_t>(chosen - areas.begin())];
        double u = next(), v = next();
        if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
        samples.push_back(surface.at(t, 0) + u * (surface.at(t, 1) - surface.at(t, 0)) +
                          v * (surface.at(t, 2) - surface.at(t, 0)));
    }
    return samples;
}

struct Distances
{
    double largest = 0.0, sum = 0.0;
};

Distances distances(const std::vector<glm::dvec3>& samples, const TriangleTree& tree)
{
    std::vector<Distances> parts(std::max(1u, std::thread::hardware_concurrency()));
    parallelShares(samples.size(), kLeastShare,
                   [&](std::size_t first, std::size_t last, std::size_t share)
                   {
                       Distances mine;
                       for (std::size_t i = first; i < last; ++i)
                       {
                           const double d = tree.distance(samples[i]);
                           mine.largest = std::max(mine.largest, d);
                           mine.sum += d;
                       }
                       parts[share] = mine;
                   });
    Distances all;
    for (const Distances& part : parts)
        all = {std::max(all.largest, part.largest), all.sum + part.sum};
    return all;
}

} // namespace

SurfaceChange surfaceChange(const Mesh& a, const Mesh& b, std::size_t spread)
{
    const Surface surfaces[] = {Surface(a), Surface(b)};
    SurfaceChange change;
    std::size_t spreadCount = 0;
    for (int side = 0; side < 2; ++side)
    {
        const Surface& other = surfaces[1 - side];
        const std::vector<glm::dvec3> fixed = fixedSamples(surfaces[side]);
        const std::vector<glm::dvec3> random = spreadSamples(surfaces[side], spread);
        const TriangleTree tree(other.mesh.positions, other.triangles);
        const Distances atFixed = distances(fixed, tree), atRandom = distances(random, tree);
        change.largest = std::max({change.largest, atFixed.largest, atRandom.largest});
        change.mean += atRandom.sum;
        change.samples += fixed.size() + random.size();
        spreadCount += random.size();
    }
    if (spreadCount > 0) change.mean /= static_cast<double>(spreadCount);
    return change;
}

} // namespace osgPMObjects::core
