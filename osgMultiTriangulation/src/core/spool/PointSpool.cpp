// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <osgMultiTriangulation/core/input/PointSet.h>
#include <osgMultiTriangulation/core/input/StripDelaunay.h>
#include <osgMultiTriangulation/core/spool/InputSpool.h>

#include "ScatterFile.h"

namespace osgMultiTriangulation::core
{

namespace
{

constexpr std::uint32_t kBins = 1u << 15; ///< of the lattice along the axis, to cut strips from

std::uint32_t binOf(const SurfacePoint& point, std::uint32_t axis)
{
    return static_cast<std::uint32_t>(axis == 0 ? point.x : point.y) / (kMostPlan / (kBins - 1) + 1);
}

std::int32_t firstOfBin(std::uint32_t bin)
{
    return static_cast<std::int32_t>(bin) * (kMostPlan / static_cast<std::int32_t>(kBins - 1) + 1);
}

/// Points in strips of about as many, in a file.
class Strips
{
public:
    static foundation::Result<Strips> create(const RecordFile<MeasuredPoint>& measured,
                                             const PlanFrame& frame, std::uint32_t axis,
                                             const std::filesystem::path& folder, SpooledInput& input)
    {
        Strips strips;
        std::vector<std::uint64_t> bins(kBins, 0);
        const auto eachPoint = [&](const auto& visit)
        {
            measured.scan(
                [&](std::span<const MeasuredPoint> run)
                {
                    for (const MeasuredPoint& point : run)
                        visit(onLattice(frame, point, input.mostMoved));
                });
        };
        eachPoint(
            [&](const SurfacePoint& p)
            {
                ++bins[binOf(p, axis)];
                strips._high[0] = std::max(strips._high[0], p.x);
                strips._high[1] = std::max(strips._high[1], p.y);
            });
        const double wanted = std::max(16384.0, 8.0 * std::sqrt(static_cast<double>(measured.size())));
        std::vector<std::uint32_t> stripOf(kBins);
        std::vector<std::uint64_t> counts(1, 0);
        for (std::uint32_t bin = 0; bin < kBins; ++bin)
        {
            if (counts.back() > 0 && static_cast<double>(counts.back() + bins[bin]) > wanted)
            {
                counts.push_back(0);
                strips._begins.push_back(firstOfBin(bin));
            }
            counts.back() += bins[bin];
            stripOf[bin] = static_cast<std::uint32_t>(counts.size() - 1);
        }
        auto file = ScatterFile<SurfacePoint>::create(folder / "strips", counts);
        if (!file) return file.error();
        strips._file = std::move(*file);
        eachPoint([&](const SurfacePoint& p) { strips._file.add(stripOf[binOf(p, axis)], p); });
        strips._file.flush();
        return strips;
    }

    std::uint32_t count() const { return static_cast<std::uint32_t>(_begins.size()) + 1; }
    std::array<std::int32_t, 2> high() const { return _high; }
    std::vector<SurfacePoint> read(std::uint32_t strip) const { return _file.read(strip); }
    foundation::Outcome outcome() const { return _file.outcome(); }

    /// A coordinate that no point after a strip is below.
    std::int32_t beginAfter(std::uint32_t strip) const { return _begins[strip]; }

private:
    std::array<std::int32_t, 2> _high{0, 0};
    std::vector<std::int32_t> _begins; ///< of the strips after the first
    ScatterFile<SurfacePoint> _file;
};

/// Leaves out points at a place that an earlier one has. Returns how many.
std::uint64_t dropRepeated(std::vector<SurfacePoint>& points)
{
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto placeOf = [&](std::uint32_t p) { return std::pair(points[p].x, points[p].y); };
    std::ranges::stable_sort(order, {}, placeOf);
    std::vector<bool> isRepeated(points.size(), false);
    for (std::size_t i = 1; i < order.size(); ++i)
        isRepeated[order[i]] = placeOf(order[i]) == placeOf(order[i - 1]);
    std::size_t count = 0;
    for (std::size_t p = 0; p < points.size(); ++p)
        if (!isRepeated[p]) points[count++] = points[p];
    const std::uint64_t repeated = points.size() - count;
    points.resize(count);
    return repeated;
}

foundation::Outcome triangulate(const Strips& strips, std::uint32_t axis, SurfaceSpool& spool,
                                SpooledInput& input)
{
    StripDelaunay delaunay([&spool](const Triangle& t) { spool.addTriangle(t); }, axis, strips.high());
    for (std::uint32_t strip = 0; strip < strips.count(); ++strip)
    {
        std::vector<SurfacePoint> points = strips.read(strip);
        input.repeated += dropRepeated(points);
        for (const SurfacePoint& point : points)
            spool.addPoint(point);
        delaunay.add(points);
        points = {};
        const auto stepped =
            strip + 1 < strips.count() ? delaunay.advance(strips.beginAfter(strip)) : delaunay.finish();
        if (!stepped) return stepped;
    }
    return foundation::success();
}

} // namespace

foundation::Result<SpooledInput> spoolPoints(const PointStream& stream, SurfaceSpool& spool)
{
    auto measured = RecordFile<MeasuredPoint>::create(spool.folder() / "measured");
    if (!measured) return measured.error();
    LatticeFinder lattice;
    const auto read = stream(
        [&](const MeasuredPoint& point)
        {
            lattice.add(point);
            measured->append(point);
        });
    if (!read) return read.error();
    measured->flush();
    SpooledInput input;
    input.frame = lattice.frame();
    const std::uint32_t axis = lattice.extent(0) >= lattice.extent(1) ? 0 : 1;
    const auto strips = Strips::create(*measured, input.frame, axis, spool.folder(), input);
    if (!strips) return strips.error();
    if (const auto whole = triangulate(*strips, axis, spool, input); !whole) return whole.error();
    for (const auto& outcome : {measured->outcome(), strips->outcome()})
        if (!outcome) return outcome.error();
    if (spool.triangles().size() == 0)
        return foundation::Error{"the points", "lie all on one line", "give points of an area"};
    return input;
}

foundation::Result<SpooledInput> spoolPointFiles(std::span<const std::filesystem::path> files,
                                                 SurfaceSpool& spool)
{
    return spoolPoints(
        [files](const auto& visit) -> foundation::Outcome
        {
            for (const std::filesystem::path& file : files)
                if (const auto read = streamPointFile(file, visit); !read) return read;
            return foundation::success();
        },
        spool);
}

} // namespace osgMultiTriangulation::core
