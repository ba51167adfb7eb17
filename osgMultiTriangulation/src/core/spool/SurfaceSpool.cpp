// SPDX-License-Identifier: Apache-2.0
#include <bit>

#include <foundation/Random.h>

#include <osgMultiTriangulation/core/spool/SurfaceSpool.h>

namespace osgMultiTriangulation::core
{

namespace
{

/// Adds a word to a sum in which every place counts (the step of FNV-1a on words).
std::uint32_t mixed(std::uint32_t sum, std::uint64_t word)
{
    std::uint64_t state = (sum ^ word) * foundation::SplitMix64::kStep;
    state ^= state >> 29;
    return static_cast<std::uint32_t>(state ^ (state >> 32));
}

static_assert(sizeof(SurfacePoint) == 16 && sizeof(Triangle) == 12);

} // namespace

foundation::Result<SurfaceSpool> SurfaceSpool::create(const std::filesystem::path& folder)
{
    SurfaceSpool spool;
    spool._folder = folder;
    auto points = RecordFile<SurfacePoint>::create(folder / "points");
    if (!points) return points.error();
    auto triangles = RecordFile<Triangle>::create(folder / "triangles");
    if (!triangles) return triangles.error();
    spool._points = std::move(*points);
    spool._triangles = std::move(*triangles);
    return spool;
}

foundation::Result<SurfaceSpool> SurfaceSpool::openPoints(const std::filesystem::path& folder,
                                                          std::uint64_t points)
{
    SurfaceSpool spool;
    spool._folder = folder;
    auto file = RecordFile<SurfacePoint>::open(folder / "points");
    if (!file) return file.error();
    if (file->size() != points)
        return foundation::Error{(folder / "points").string(), "has another size than it was written with",
                                 "plan the build again"};
    spool._points = std::move(*file);
    return spool;
}

void SurfaceSpool::addPoint(const SurfacePoint& point)
{
    _points.append(point); // 4 + 4 + 8 bytes: there are none between them
    _heights.add(point.height);
    _sum = mixed(_sum, std::uint64_t(std::uint32_t(point.x)) << 32 | std::uint32_t(point.y));
    _sum = mixed(_sum, std::bit_cast<std::uint64_t>(point.height));
}

void SurfaceSpool::addTriangle(const Triangle& triangle)
{
    _triangles.append(triangle);
    _sum = mixed(_sum, std::uint64_t(triangle[0]) << 32 | triangle[1]);
    _sum = mixed(_sum, triangle[2]);
}

foundation::Outcome SurfaceSpool::finish()
{
    _points.flush();
    _triangles.flush();
    if (const auto outcome = _points.outcome(); !outcome) return outcome;
    return _triangles.outcome();
}

} // namespace osgMultiTriangulation::core
