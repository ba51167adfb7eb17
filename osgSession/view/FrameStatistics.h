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

/// The figures of one frame. Times and memory are measurements; the others follow from scenario and view
/// only.
/// Units: as the names say; microseconds and milliseconds of one thread, but wallMs and processorMs.
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
    double maxErrorPx = 0.0; ///< bound reached, anywhere in the image; infinite: none is known yet
    std::optional<ObjectFigures> objects; ///< absent without a scenery
    double wallMs = 0.0;           ///< from the eye's move to the end of drawing, by the clock on the wall
    double processorMs = 0.0;      ///< of all threads of the process, in the same time
    std::uint64_t uploadBytes = 0; ///< of the terrain, to all contexts
    double residentMb = 0.0;       ///< memory of the process that is in use
};

/// One column of the statistics.
struct StatisticsColumn
{
    std::string_view name; ///< the key in stats.json
    double (*value)(const FrameStatistics&);
    bool isWhole;    ///< counts
    bool isMeasured; ///< depends on the machine
};

/// Returns all columns except `frame` and `timeS` in the order of the file; those of objects only when a
/// frame has objects.
const std::vector<StatisticsColumn>& statisticsColumns(const std::vector<FrameStatistics>& frames);

/// The summary of one column. Median: the middle value or the mean of the two middle values. p99: the
/// smallest value that at least 99 % of the frames do not exceed (nearest rank). All 0 without frames.
/// The first frame builds meshes and compiles shaders: of several frames it stands apart, and the others are
/// summed up.
struct ColumnSummary
{
    double median = 0.0;
    double p99 = 0.0;
    double largest = 0.0;
    double first = 0.0; ///< of the first frame
};
/// Sums up all values; `first` stays 0.
ColumnSummary summaryOf(std::vector<double> values);
ColumnSummary summaryOf(const std::vector<FrameStatistics>& frames, const StatisticsColumn& column);

} // namespace trainer
