// SPDX-License-Identifier: Apache-2.0
#include "SpoolBorder.h"

#include <filesystem>

#include "../split/BorderTrial.h"
#include "SpoolSource.h"

namespace osgMultiTriangulation::core
{

namespace
{

/// Counts the points of triangles whose corners lie in several rectangles.
foundation::Result<std::uint64_t> borderPointsOf(const SurfaceSpool& spool, const BorderTrial& trial)
{
    constexpr std::size_t kFitBlocks = 256; // of a cache
    const std::filesystem::path file = spool.folder() / "border-fit";
    auto marks = RecordFile<std::uint8_t>::create(file);
    if (!marks) return marks.error();
    for (std::uint64_t point = 0; point < spool.points().size(); ++point)
        marks->append(0);
    marks->flush();
    RecordCache<SurfacePoint> places(spool.points(), kFitBlocks);
    RecordCache<std::uint8_t> marked(*marks, kFitBlocks);
    std::uint64_t borderPoints = 0;
    spool.triangles().scan(
        [&](std::span<const Triangle> run)
        {
            for (const Triangle& t : run)
            {
                const std::uint32_t part = trial.partAt(places.at(t[0]));
                if (trial.partAt(places.at(t[1])) == part && trial.partAt(places.at(t[2])) == part) continue;
                for (const std::uint32_t corner : t)
                {
                    if (marked.at(corner) != 0) continue;
                    marked.set(corner, 1);
                    ++borderPoints;
                }
            }
        });
    marked.flush();
    for (const auto& outcome : {spool.points().outcome(), spool.triangles().outcome(), marks->outcome()})
        if (!outcome) return outcome.error();
    std::error_code ignored; // what stays is room on the disk, no more
    std::filesystem::remove(file, ignored);
    return borderPoints;
}

} // namespace

foundation::Result<BorderModel> fitBorder(const SurfaceSpool& spool, SplitAt where)
{
    BorderModel model;
    for (int round = 0; round < BorderTrial::kRounds; ++round)
    {
        const BorderTrial trial(scanOf(spool), spool.points().size(), where, model);
        if (!trial.hasBorders()) return model;
        const auto borderPoints = borderPointsOf(spool, trial);
        if (!borderPoints) return borderPoints.error();
        model = trial.fitted(*borderPoints);
    }
    return model;
}

} // namespace osgMultiTriangulation::core
