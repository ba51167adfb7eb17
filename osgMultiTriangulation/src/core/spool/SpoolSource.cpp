// SPDX-License-Identifier: Apache-2.0
#include "SpoolSource.h"

#include <algorithm>
#include <limits>

namespace osgMultiTriangulation::core
{

namespace
{

constexpr std::size_t kPointBlocks = 64;    ///< of a cache
constexpr std::size_t kScatterBlocks = 256; ///< while triangles are dealt out

constexpr const char *kJoinedName = "joined", *kByPartName = "triangles-of-parts";

class SpoolPoints : public PartSource::Points
{
public:
    SpoolPoints(const RecordFile<SurfacePoint>& points, const RecordFile<std::uint8_t>& joinedAt)
        : _points(points, kPointBlocks), _joinedAt(joinedAt, kPointBlocks)
    {
    }

    SourcePoint at(std::uint32_t number) override { return {_points.at(number), _joinedAt.at(number)}; }

private:
    RecordCache<SurfacePoint> _points;
    RecordCache<std::uint8_t> _joinedAt;
};

} // namespace

foundation::Result<std::unique_ptr<SpoolSource>> SpoolSource::create(const SurfaceSpool& spool,
                                                                     const Partition& partition,
                                                                     const std::filesystem::path& folder)
{
    std::unique_ptr<SpoolSource> source(new SpoolSource(spool, partition));
    auto joinedAt = RecordFile<std::uint8_t>::create(folder / kJoinedName);
    if (!joinedAt) return joinedAt.error();
    source->_joinedAt = std::move(*joinedAt);
    auto byPart = ScatterFile<Triangle>::create(folder / kByPartName, source->countParts());
    if (!byPart) return byPart.error();
    source->_byPart = std::move(*byPart);
    source->scatter();
    if (const auto outcome = source->outcome(); !outcome) return outcome.error();
    return source;
}

foundation::Result<std::unique_ptr<SpoolSource>> SpoolSource::open(const SurfaceSpool& spool,
                                                                   const Partition& partition,
                                                                   const std::vector<std::uint64_t>& counts)
{
    std::unique_ptr<SpoolSource> source(new SpoolSource(spool, partition));
    const std::filesystem::path joined = spool.folder() / kJoinedName;
    auto joinedAt = RecordFile<std::uint8_t>::open(joined);
    if (!joinedAt) return joinedAt.error();
    if (joinedAt->size() != spool.points().size())
        return foundation::Error{joined.string(), "has another size than it was written with",
                                 "plan the build again"};
    source->_joinedAt = std::move(*joinedAt);
    auto byPart = ScatterFile<Triangle>::open(spool.folder() / kByPartName, counts);
    if (!byPart) return byPart.error();
    source->_byPart = std::move(*byPart);
    return source;
}

std::uint32_t SpoolSource::holderOf(const Triangle& triangle, RecordCache<SurfacePoint>& places) const
{
    std::uint32_t holder = _partition.partAt(places.at(triangle[0]));
    for (int c = 1; c < 3; ++c)
        holder = _partition.common(holder, _partition.partAt(places.at(triangle[c])));
    return holder;
}

std::vector<std::uint64_t> SpoolSource::countParts()
{
    for (std::uint64_t p = 0; p < _spool.points().size(); ++p)
        _joinedAt.append(255);
    _joinedAt.flush();
    std::vector<std::uint64_t> counts(_partition.parts.size(), 0);
    RecordCache<SurfacePoint> places(_spool.points(), kScatterBlocks);
    RecordCache<std::uint8_t> joined(_joinedAt, kScatterBlocks);
    _spool.triangles().scan(
        [&](std::span<const Triangle> run)
        {
            for (const Triangle& t : run)
            {
                const std::uint32_t holder = holderOf(t, places);
                const std::uint8_t depth = _partition.joinDepth(holder);
                for (const std::uint32_t corner : t)
                    if (depth < joined.at(corner)) joined.set(corner, depth);
                ++counts[holder];
            }
        });
    joined.flush();
    return counts;
}

void SpoolSource::scatter()
{
    RecordCache<SurfacePoint> places(_spool.points(), kScatterBlocks);
    _spool.triangles().scan(
        [&](std::span<const Triangle> run)
        {
            for (const Triangle& t : run)
                _byPart.add(holderOf(t, places), t);
        });
    _byPart.flush();
}

std::unique_ptr<PartSource::Points> SpoolSource::points() const
{
    return std::make_unique<SpoolPoints>(_spool.points(), _joinedAt);
}

std::vector<Triangle> SpoolSource::trianglesOf(std::uint32_t part) const
{
    return _byPart.read(part);
}

foundation::Outcome SpoolSource::outcome() const
{
    for (const auto& outcome :
         {_spool.points().outcome(), _spool.triangles().outcome(), _joinedAt.outcome(), _byPart.outcome()})
        if (!outcome) return outcome;
    return foundation::success();
}

PointScan scanOf(const SurfaceSpool& spool)
{
    return [&spool](const std::function<void(std::span<const SurfacePoint>)>& visit)
    { spool.points().scan(visit); };
}

} // namespace osgMultiTriangulation::core
