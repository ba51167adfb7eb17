// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/mesh/FirstAtPlace.h>
#include <osgPMObjects/core/mesh/SurfaceChange.h>

namespace osgPMObjects::core
{

namespace
{

/// Samples are measured in chunks, whose results are joined in order: the sums do not depend on the number of
/// threads.
constexpr std::size_t kChunk = 1024;
/// Triangles that may be looked at for each sample of a chunk, and for all corners and centres together,
/// where most triangles cross the whole mesh; samples that are left then are not measured. Known models need
/// up to 130 for a spread sample, 80 for a corner or centre.
constexpr std::uint64_t kMostTrianglesASpreadSample = 160, kMostTrianglesASample = 256,
                        kMostTrianglesOfCorners = 1u << 25;

struct Sums
{
    double largest = 0.0, sum = 0.0, squares = 0.0;
    std::size_t samples = 0;
};

/// Calls work(first, last, chunk) for each chunk of so many samples, in several threads.
template<class Work>
void forEachChunk(std::size_t samples, const Work& work)
{
    parallelShares((samples + kChunk - 1) / kChunk, 2,
                   [&](std::size_t first, std::size_t last, std::size_t)
                   {
                       for (std::size_t chunk = first; chunk < last; ++chunk)
                           work(chunk * kChunk, std::min(samples, (chunk + 1) * kChunk), chunk);
                   });
}

/// Returns the bound of the distance at the next sample: it changes by at most the way between two samples.
double boundAfter(double distance, const glm::dvec3& here, const glm::dvec3& next)
{
    return (distance + glm::length(next - here)) * (1.0 + 1e-9);
}

/// Measures the spread points of a surface.
Sums distancesOf(const std::vector<SurfacePoint>& samples, const TriangleTree& tree)
{
    std::vector<Sums> chunks((samples.size() + kChunk - 1) / kChunk);
    forEachChunk(samples.size(),
                 [&](std::size_t first, std::size_t last, std::size_t chunk)
                 {
                     Sums& found = chunks[chunk];
                     double most = std::numeric_limits<double>::infinity();
                     std::uint64_t work = kMostTrianglesASpreadSample * (last - first);
                     for (std::size_t i = first; i < last; ++i)
                     {
                         const auto measured = tree.distance(samples[i].position, most, work);
                         if (!measured) break;
                         const double d = *measured;
                         ++found.samples;
                         found.largest = std::max(found.largest, d);
                         found.sum += d;
                         found.squares += d * d;
                         if (i + 1 < last) most = boundAfter(d, samples[i].position, samples[i + 1].position);
                     }
                 });
    Sums all;
    for (const Sums& chunk : chunks)
        all = {std::max(all.largest, chunk.largest), all.sum + chunk.sum, all.squares + chunk.squares,
               all.samples + chunk.samples};
    return all;
}

/// Returns the distance of a point from a surface; where that is at most `enough`, some number from it to
/// `enough`.
double distanceAbove(const glm::dvec3& point, const MeasuredSurface& surface, double enough, double most,
                     std::uint64_t& work)
{
    if (most <= enough || work == 0) return std::min(most, enough);
    const std::vector<glm::dvec3>& positions = surface.mesh().positions;
    double least = most * most, bound = least;
    surface.tree().visitNear(point, bound,
                             [&](std::uint32_t triangle)
                             {
                                 const Triangle& t = surface.triangles()[triangle];
                                 const glm::dvec3 away =
                                     point -
                                     nearestPoint(point, positions[t[0]], positions[t[1]], positions[t[2]]);
                                 least = std::min(least, glm::dot(away, away));
                                 work -= work > 0;
                                 const bool isDone = least <= enough * enough || work == 0;
                                 bound = isDone ? -1.0 : least; // below 0: no box is nearer
                             });
    return work == 0 ? std::min(enough, std::sqrt(least)) : std::sqrt(least);
}

/// Returns the corners and centres of a surface that are not also such points of the other: those lie on it.
std::vector<glm::dvec3> pointsWithout(const std::vector<glm::dvec3>& points,
                                      const std::vector<glm::dvec3>& others)
{
    std::vector<glm::dvec3> all = others;
    all.insert(all.end(), points.begin(), points.end());
    const std::vector<std::uint32_t> first = firstAtPlace(all);
    std::vector<glm::dvec3> left;
    for (std::size_t i = others.size(); i < all.size(); ++i)
        if (first[i] >= others.size()) left.push_back(all[i]);
    return left;
}

/// Returns the largest distance of points from a surface, at least `atLeast`.
double largestOf(const std::vector<glm::dvec3>& points, const MeasuredSurface& surface, double atLeast)
{
    const std::uint64_t trianglesAPoint = std::min(
        kMostTrianglesASample, kMostTrianglesOfCorners / std::max<std::size_t>(points.size(), 1) + 1);
    std::vector<double> chunks((points.size() + kChunk - 1) / kChunk, atLeast);
    forEachChunk(points.size(),
                 [&](std::size_t first, std::size_t last, std::size_t chunk)
                 {
                     double& largest = chunks[chunk];
                     std::uint64_t work = trianglesAPoint * (last - first);
                     double most = std::numeric_limits<double>::infinity();
                     for (std::size_t i = first; i < last; ++i)
                     {
                         const double d = distanceAbove(points[i], surface, largest, most, work);
                         largest = std::max(largest, d);
                         if (i + 1 < last) most = boundAfter(d, points[i], points[i + 1]);
                     }
                 });
    for (const double chunk : chunks)
        atLeast = std::max(atLeast, chunk);
    return atLeast;
}

/// Moves a point of a triangle to larger distances from a surface, by smaller and smaller ways, while there
/// is work left.
double climbed(SurfacePoint point, double distance, const MeasuredSurface& from, const TriangleTree& to,
               std::uint64_t work)
{
    constexpr double kFirstWay = 0.2, kLastWay = 0.004; // in edges
    constexpr double kDirections[][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}};
    const std::vector<glm::dvec3>& positions = from.mesh().positions;
    const Triangle& t = from.triangles()[point.triangle];
    const glm::dvec3 a = positions[t[0]], ab = positions[t[1]] - a, ac = positions[t[2]] - a;
    for (double way = kFirstWay; way > kLastWay;)
    {
        SurfacePoint best = point;
        double most = distance;
        for (const auto& direction : kDirections)
        {
            SurfacePoint next = point;
            next.second = std::clamp(point.second + way * direction[0], 0.0, 1.0);
            next.third = std::clamp(point.third + way * direction[1], 0.0, 1.0 - next.second);
            next.position = a + next.second * ab + next.third * ac;
            const auto d =
                to.distance(next.position, boundAfter(distance, point.position, next.position), work);
            if (!d) return distance;
            if (*d > most) best = next, most = *d;
        }
        if (most > distance)
            point = best, distance = most;
        else
            way *= 0.5;
    }
    return distance;
}

} // namespace

double farthestDistance(const MeasuredSurface& from, const MeasuredSurface& to, double atLeast)
{
    constexpr std::size_t kLeastSamplesAStart = 8, kMostStarts = 1024;
    constexpr double kShare = 0.6; // of the largest distance: nearer starts hardly lead beyond it
    const std::vector<SurfacePoint>& samples = from.spreadPoints();
    const std::size_t each = std::max(kLeastSamplesAStart, samples.size() / kMostStarts);
    std::vector<double> farthest((samples.size() + each - 1) / each, atLeast);
    if (!std::isfinite(atLeast)) return atLeast;
    const auto search = [&](std::size_t start)
    {
        double most = 0.0;
        std::uint64_t work = kMostTrianglesASample * each;
        std::size_t at = start * each;
        for (std::size_t i = at; i < std::min(samples.size(), (start + 1) * each); ++i)
        {
            const double d = distanceAbove(samples[i].position, to, std::max(most, kShare * atLeast),
                                           std::numeric_limits<double>::infinity(), work);
            if (d > most) most = d, at = i;
        }
        if (most > kShare * atLeast)
            farthest[start] = std::max(atLeast, climbed(samples[at], most, from, to.tree(), work));
    };
    parallelShares(farthest.size(), 2,
                   [&](std::size_t first, std::size_t last, std::size_t)
                   {
                       for (std::size_t start = first; start < last; ++start)
                           search(start);
                   });
    for (const double distance : farthest)
        atLeast = std::max(atLeast, distance);
    return atLeast;
}

SurfaceDistance surfaceDistance(const MeasuredSurface& from, const MeasuredSurface& to)
{
    const Sums spread = distancesOf(from.spreadPoints(), to.tree());
    const double count = std::max(1.0, static_cast<double>(spread.samples));
    return {largestOf(pointsWithout(from.fixedPoints(), to.fixedPoints()), to, spread.largest),
            spread.sum / count, std::sqrt(spread.squares / count), spread.samples};
}

SurfaceChange surfaceChange(const MeasuredSurface& a, const MeasuredSurface& b)
{
    const SurfaceDistance there = surfaceDistance(a, b), back = surfaceDistance(b, a);
    const auto countA = static_cast<double>(there.spreadSamples),
               countB = static_cast<double>(back.spreadSamples);
    SurfaceChange change;
    change.largest = std::max(there.largest, back.largest);
    if (countA + countB > 0.0) change.mean = (there.mean * countA + back.mean * countB) / (countA + countB);
    change.samples =
        a.fixedPoints().size() + there.spreadSamples + b.fixedPoints().size() + back.spreadSamples;
    return change;
}

SurfaceChange surfaceChange(const Mesh& a, const Mesh& b, std::size_t spread)
{
    return surfaceChange(MeasuredSurface(a, spread), MeasuredSurface(b, spread));
}

} // namespace osgPMObjects::core
