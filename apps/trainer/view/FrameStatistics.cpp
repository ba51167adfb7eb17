// SPDX-License-Identifier: Apache-2.0
#include "view/FrameStatistics.h"

#include <algorithm>
#include <array>

namespace trainer
{

const std::vector<StatisticsColumn>& statisticsColumns()
{
    static const std::vector<StatisticsColumn> columns = {
        {"triangles", [](const FrameStatistics& f) { return static_cast<double>(f.triangles); }, true, false},
        {"splits", [](const FrameStatistics& f) { return static_cast<double>(f.splits); }, true, false},
        {"merges", [](const FrameStatistics& f) { return static_cast<double>(f.merges); }, true, false},
        {"adaptUs", [](const FrameStatistics& f) { return f.adaptUs; }, false, true},
        {"cullMs", [](const FrameStatistics& f) { return f.cullMs; }, false, true},
        {"drawMs", [](const FrameStatistics& f) { return f.drawMs; }, false, true},
        {"maxErrorPx", [](const FrameStatistics& f) { return f.maxErrorPx; }, false, false}};
    return columns;
}

ColumnSummary summaryOf(std::vector<double> values)
{
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    const std::size_t rank99 = (99 * n + 99) / 100; // rounded up
    return {0.5 * (values[(n - 1) / 2] + values[n / 2]), values[rank99 - 1], values.back()};
}

ColumnSummary summaryOf(const std::vector<FrameStatistics>& frames, const StatisticsColumn& column)
{
    std::vector<double> values;
    for (const FrameStatistics& frame : frames)
        values.push_back(column.value(frame));
    return summaryOf(std::move(values));
}

} // namespace trainer
