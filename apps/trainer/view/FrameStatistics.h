// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include <osgPMObjects/core/selection/SelectionStatistics.h>

namespace trainer
{

/// What became of a scenery's objects in one frame, of all eyes together.
struct ObjectFigures
{
    std::uint32_t visible = 0;   ///< in sight of a frustum
    std::uint32_t drawn = 0;     ///< of those, not beyond their alpha range
    std::uint32_t switching = 0; ///< on their way from one level to another
    std::uint64_t triangles = 0;
    double cullMs = 0.0;                               ///< choosing and sorting
    osgPMObjects::core::SelectionStatistics selection; ///< by method
};

/// What one frame took. The first five and the last follow from scenario and view alone; the times are measurements
/// of this run. Units: as the names say; microseconds and milliseconds of one thread.
struct FrameStatistics
{
    std::uint32_t frame = 0;
    double timeS = 0.0; ///< simulated
    std::uint32_t triangles = 0;
    std::uint32_t splits = 0;
    std::uint32_t merges = 0;
    double adaptUs = 0.0;
    double cullMs = 0.0;
    double drawMs = 0.0;
    double maxErrorPx = 0.0;              ///< bound reached, anywhere in the picture
    std::optional<ObjectFigures> objects; ///< absent without a scenery
};

/// One column of the statistics.
struct StatisticsColumn
{
    std::string_view name; ///< the key in stats.json
    double (*value)(const FrameStatistics&);
    bool isWhole;    ///< counts
    bool isMeasured; ///< depends on the machine
};

/// All columns but `frame` and `timeS`, in the order in which they are written; those of objects only where a frame has some.
const std::vector<StatisticsColumn>& statisticsColumns(const std::vector<FrameStatistics>& frames);

/// Of one column over all frames. Median: the middle value, or the mean of the two middle ones. p99: the smallest
/// value that at least 99 % of the frames do not exceed (nearest rank). All 0 without frames.
struct ColumnSummary
{
    double median = 0.0;
    double p99 = 0.0;
    double largest = 0.0;
};
ColumnSummary summaryOf(std::vector<double> values);
ColumnSummary summaryOf(const std::vector<FrameStatistics>& frames, const StatisticsColumn& column);

} // namespace trainer
