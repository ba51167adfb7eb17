// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

namespace trainer
{

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
    double maxErrorPx = 0.0; ///< bound reached, anywhere in the picture
};

/// One column of the statistics.
struct StatisticsColumn
{
    std::string_view name; ///< the key in stats.json
    double (*value)(const FrameStatistics&);
    bool isWhole;    ///< counts
    bool isMeasured; ///< depends on the machine
};

/// All columns but `frame` and `timeS`, in the order in which they are written.
const std::vector<StatisticsColumn>& statisticsColumns();

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
