// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <thread>
#include <vector>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/mesh/SurfaceChange.h>

namespace osgPMObjects::core
{

namespace
{

constexpr std::size_t kLeastSamplesAThread = 2048;

const glm::dvec3& placeOf(const glm::dvec3& point)
{
    return point;
}

const glm::dvec3& placeOf(const SurfacePoint& point)
{
    return point.position;
}

struct Distances
{
    double largest = 0.0, sum = 0.0;
};

/// Measures neighbouring samples in sequence: the distance to a surface changes by at most the way between two samples, which
/// bounds the search in the tree.
template<class Point>
Distances distancesOf(const std::vector<Point>& samples, std::size_t first, std::size_t last,
                      const TriangleTree& tree)
{
    Distances found;
    double most = std::numeric_limits<double>::infinity();
    for (std::size_t i = first; i < last; ++i)
    {
        const glm::dvec3& place = placeOf(samples[i]);
        const double d = tree.distance(place, most);
        found.largest = std::max(found.largest, d);
        found.sum += d;
        if (i + 1 < last) most = (d + glm::length(placeOf(samples[i + 1]) - place)) * (1.0 + 1e-9);
    }
    return found;
}

template<class Point>
Distances distances(const std::vector<Point>& samples, const TriangleTree& tree)
{
    std::vector<Distances> parts(std::max(1u, std::thread::hardware_concurrency()));
    parallelShares(samples.size(), kLeastSamplesAThread,
                   [&](std::size_t first, std::size_t last, std::size_t share)
                   { parts[share] = distancesOf(samples, first, last, tree); });
    Distances all;
    for (const Distances& part : parts)
        all = {std::max(all.largest, part.largest), all.sum + part.sum};
    return all;
}

} // namespace

SurfaceChange surfaceChange(const MeasuredSurface& a, const MeasuredSurface& b)
{
    const MeasuredSurface* surfaces[] = {&a, &b};
    SurfaceChange change;
    std::size_t spreadCount = 0;
    for (int side = 0; side < 2; ++side)
    {
        const MeasuredSurface& from = *surfaces[side];
        const TriangleTree& tree = surfaces[1 - side]->tree();
        const Distances atFixed = distances(from.fixedPoints(), tree);
        const Distances atSpread = distances(from.spreadPoints(), tree);
        change.largest = std::max({change.largest, atFixed.largest, atSpread.largest});
        change.mean += atSpread.sum;
        change.samples += from.fixedPoints().size() + from.spreadPoints().size();
        spreadCount += from.spreadPoints().size();
    }
    if (spreadCount > 0) change.mean /= static_cast<double>(spreadCount);
    return change;
}

SurfaceChange surfaceChange(const Mesh& a, const Mesh& b, std::size_t spread)
{
    return surfaceChange(MeasuredSurface(a, spread), MeasuredSurface(b, spread));
}

} // namespace osgPMObjects::core
