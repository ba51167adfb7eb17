// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a file of points: they become finite points, or are refused with a line. On a
// lattice they lie within it, no two at one place, and their triangles are counter-clockwise.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <sstream>
#include <string>

#include <osgMultiTriangulation/core/input/Delaunay.h>
#include <osgMultiTriangulation/core/input/PointSet.h>

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace osgMultiTriangulation::core;
    std::istringstream stream(std::string(reinterpret_cast<const char*>(data), size));
    std::vector<MeasuredPoint> points;
    const auto read =
        streamPoints(stream, "fuzzed", [&](const MeasuredPoint& point) { points.push_back(point); });
    for (const MeasuredPoint& point : points)
        for (const double value : point)
            if (!std::isfinite(value)) std::abort();
    if (!read) return 0;
    if (points.empty()) std::abort();
    PlacedPoints placed = placeOnLattice(points);
    if (placed.points.size() + placed.repeated != points.size()) std::abort();
    std::set<std::pair<std::int32_t, std::int32_t>> places;
    for (const SurfacePoint& p : placed.points)
        if (p.x < 0 || p.y < 0 || p.x > 1 << 26 || p.y > 1 << 26 || !places.emplace(p.x, p.y).second)
            std::abort();
    const SurfaceMesh mesh = delaunay(std::move(placed.points));
    for (const Triangle& t : mesh.triangles)
        if (!(twiceArea(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]) > 0.0)) std::abort();
    return 0;
}
