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

/// The figures of the objects of a scenery in one frame, summed over all cameras.
struct ObjectFigures
{
    std::uint32_t visible = 0;   ///< inside a frustum
    std::uint32_t drawn = 0;     ///< visible and not faded out
    std::uint32_t switching = 0; ///< switching between two levels
    std::uint64_t triangles = 0;
    double cullMs = 0.0;                               ///< choosing and sorting
    osgPMObjects::core::SelectionStatistics selection; ///< by method
};

/// The figures of one frame. The first five and the last follow from scenario and view only; the times are
/// measurements. Units: as the names say; microseconds and milliseconds of one thread.
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
    double maxErrorPx = 0.0;              ///< bound reached, anywhere in the image
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

/// Returns all columns except `frame` and `timeS` in the order of the file; those of objects only when a frame has
/// objects.
const std::vector<StatisticsColumn>& statisticsColumns(const std::vector<FrameStatistics>& frames);

/// The summary of one column. Median: the middle value or the mean of the two middle values. p99: the smallest value
/// that at least 99 % of the frames do not exceed (nearest rank). All 0 without frames.
struct ColumnSummary
{
    double median = 0.0;
    double p99 = 0.0;
    double largest = 0.0;
};
ColumnSummary summaryOf(std::vector<double> values);
ColumnSummary summaryOf(const std::vector<FrameStatistics>& frames, const StatisticsColumn& column);

} // namespace trainer
