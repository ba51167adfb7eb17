// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <foundation/Random.h>

#include <osgMultiTriangulation/core/input/TinFile.h>
#include <osgMultiTriangulation/core/spool/InputSpool.h>

#include "../input/TinPlaces.h"
#include "ScatterFile.h"

namespace osgMultiTriangulation::core
{

namespace
{

constexpr std::uint64_t kPointsAtOnce = 1u << 15; ///< of those that are compared with each other
constexpr std::size_t kTinBlocks = 256;           ///< of each cache

/// A point on the lattice with its number in the file.
struct NumberedPoint
{
    SurfacePoint point;
    std::uint32_t number, unused;

    auto key() const { return std::tuple(point.x, point.y, number); }
};

/// A TIN on its way from a file to a spool.
class TinSpooling : public TinSink
{
public:
    TinSpooling(SurfaceSpool& spool, std::string name) : _spool(spool), _name(std::move(name)) {}

    foundation::Result<SpooledInput> spool(const std::filesystem::path& file)
    {
        if (const auto opened = openAll(); !opened) return opened.error();
        if (const auto read = streamTinFile(file, *this); !read) return read.error();
        _points.flush();
        _triangles.flush();
        _input.frame = _lattice.frame();
        if (const auto joined = joinPlaces(); !joined) return joined.error();
        if (const auto numbered = numberPoints(); !numbered) return numbered.error();
        if (const auto added = addTriangles(); !added) return added.error();
        for (const auto& outcome : {_points.outcome(), _triangles.outcome(), _numbers.outcome()})
            if (!outcome) return outcome.error();
        return _input;
    }

    void add(const MeasuredPoint& point) override
    {
        _lattice.add(point);
        _points.append(point);
        _numbers.append(kNone);
    }

    void add(const Triangle& triangle) override { _triangles.append(triangle); }

private:
    foundation::Outcome openAll()
    {
        auto points = RecordFile<MeasuredPoint>::create(_spool.folder() / "measured");
        if (!points) return points.error();
        auto triangles = RecordFile<Triangle>::create(_spool.folder() / "faces");
        if (!triangles) return triangles.error();
        auto numbers = RecordFile<std::uint32_t>::create(_spool.folder() / "numbers");
        if (!numbers) return numbers.error();
        _points = std::move(*points);
        _triangles = std::move(*triangles);
        _numbers = std::move(*numbers);
        return foundation::success();
    }

    template<class Visit>
    void eachPlace(const Visit& visit)
    {
        std::uint32_t number = 0;
        _points.scan(
            [&](std::span<const MeasuredPoint> run)
            {
                for (const MeasuredPoint& point : run)
                    visit(onLattice(_input.frame, point, _input.mostMoved), number++);
            });
    }

    /// Finds points at one place: _numbers becomes the first number there.
    foundation::Outcome joinPlaces()
    {
        _numbers.flush();
        const std::uint64_t groups = _points.size() / kPointsAtOnce * 2 + 1;
        const auto groupOf = [groups](const SurfacePoint& p)
        {
            const std::uint64_t mixed = (std::uint64_t(std::uint32_t(p.x)) << 32 | std::uint32_t(p.y)) *
                                        foundation::SplitMix64::kStep;
            return static_cast<std::uint32_t>((mixed >> 32) % groups);
        };
        std::vector<std::uint64_t> counts(groups, 0);
        eachPlace([&](const SurfacePoint& p, std::uint32_t) { ++counts[groupOf(p)]; });
        auto scattered = ScatterFile<NumberedPoint>::create(_spool.folder() / "places", counts);
        if (!scattered) return scattered.error();
        eachPlace(
            [&](const SurfacePoint& p, std::uint32_t number) {
                scattered->add(groupOf(p), {p, number, 0});
            });
        scattered->flush();
        RecordCache<std::uint32_t> first(_numbers, kTinBlocks);
        std::optional<std::uint32_t> twoHeights;
        for (std::uint32_t group = 0; group < groups; ++group)
        {
            std::vector<NumberedPoint> points = scattered->read(group);
            std::ranges::sort(points, {}, &NumberedPoint::key);
            for (std::size_t i = 0, run = 0; i < points.size(); ++i)
            {
                const SurfacePoint &here = points[i].point, &there = points[run].point;
                if (here.x != there.x || here.y != there.y) run = i;
                if (here.height != points[run].point.height)
                    twoHeights = std::min(twoHeights.value_or(kNone), points[i].number);
                first.set(points[i].number, points[run].number);
            }
        }
        first.flush();
        if (!twoHeights) return scattered->outcome();
        MeasuredPoint at{};
        _points.read({&at, 1}, *twoHeights);
        return twoHeightsAt(_name, at);
    }

    /// Numbers the places that have triangles, in the order of their first points, and adds them to the
    /// spool.
    foundation::Outcome numberPoints()
    {
        auto used = RecordFile<std::uint8_t>::create(_spool.folder() / "used");
        if (!used) return used.error();
        for (std::uint64_t p = 0; p < _points.size(); ++p)
            used->append(0);
        used->flush();
        RecordCache<std::uint8_t> isUsed(*used, kTinBlocks);
        RecordCache<std::uint32_t> numbers(_numbers, kTinBlocks);
        _triangles.scan(
            [&](std::span<const Triangle> run)
            {
                for (const Triangle& t : run)
                    for (const std::uint32_t corner : t)
                        isUsed.set(numbers.at(corner), 1);
            });
        std::uint32_t count = 0;
        eachPlace(
            [&](const SurfacePoint& p, std::uint32_t number)
            {
                const std::uint32_t first = numbers.at(number);
                if (first < number)
                    numbers.set(number, numbers.at(first)); // it has its new number already
                else if (isUsed.at(number) != 0)
                {
                    numbers.set(number, count++);
                    _spool.addPoint(p);
                }
                else
                    numbers.set(number, kNone);
            });
        numbers.flush();
        return used->outcome();
    }

    foundation::Outcome addTriangles()
    {
        if (const auto whole = _spool.finish(); !whole) return whole;
        RecordCache<std::uint32_t> numbers(_numbers, kTinBlocks);
        RecordCache<SurfacePoint> places(_spool.points(), kTinBlocks);
        std::uint64_t number = 0;
        std::optional<std::uint64_t> flat;
        _triangles.scan(
            [&](std::span<const Triangle> run)
            {
                for (Triangle t : run)
                {
                    for (std::uint32_t& corner : t)
                        corner = numbers.at(corner);
                    const SurfacePoint a = places.at(t[0]), b = places.at(t[1]), c = places.at(t[2]);
                    const double area = twiceArea(a, b, c);
                    if (area == 0.0 && !flat) flat = number;
                    if (area < 0.0) std::swap(t[1], t[2]);
                    _spool.addTriangle(t);
                    ++number;
                }
            });
        if (!flat) return foundation::success();
        Triangle triangle{};
        _triangles.read({&triangle, 1}, *flat);
        MeasuredPoint at{};
        _points.read({&at, 1}, triangle[0]);
        return noAreaAt(_name, *flat, at);
    }

    SurfaceSpool& _spool;
    std::string _name;
    LatticeFinder _lattice;
    RecordFile<MeasuredPoint> _points;
    RecordFile<Triangle> _triangles;
    RecordFile<std::uint32_t>
        _numbers; ///< by point of the file: the first at its place; then the number in the spool
    SpooledInput _input;
};

} // namespace

foundation::Result<SpooledInput> spoolTinFile(const std::filesystem::path& file, SurfaceSpool& spool)
{
    return TinSpooling(spool, file.string()).spool(file);
}

} // namespace osgMultiTriangulation::core
