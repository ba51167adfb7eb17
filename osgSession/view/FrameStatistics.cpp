// SPDX-License-Identifier: Apache-2.0
#include "view/FrameStatistics.h"

#include <algorithm>
#include <array>

namespace trainer
{

namespace
{

const std::vector<StatisticsColumn> kLandColumns = {
    {"triangles", [](const FrameStatistics& f) { return static_cast<double>(f.triangles); }, true, false},
    {"splits", [](const FrameStatistics& f) { return static_cast<double>(f.splits); }, true, false},
    {"merges", [](const FrameStatistics& f) { return static_cast<double>(f.merges); }, true, false},
    {"adaptUs", [](const FrameStatistics& f) { return f.adaptUs; }, false, true},
    {"cullMs", [](const FrameStatistics& f) { return f.cullMs; }, false, true},
    {"drawMs", [](const FrameStatistics& f) { return f.drawMs; }, false, true},
    {"maxErrorPx", [](const FrameStatistics& f) { return f.maxErrorPx; }, false, false},
    {"wallMs", [](const FrameStatistics& f) { return f.wallMs; }, false, true},
    {"processorMs", [](const FrameStatistics& f) { return f.processorMs; }, false, true},
    {"uploadBytes", [](const FrameStatistics& f) { return static_cast<double>(f.uploadBytes); }, true, false},
    {"residentMb", [](const FrameStatistics& f) { return f.residentMb; }, false, true}};

template<auto member>
double ofObjects(const FrameStatistics& frame)
{
    return frame.objects ? static_cast<double>((*frame.objects).*member) : 0.0;
}

std::vector<StatisticsColumn> withObjects()
{
    std::vector<StatisticsColumn> columns = kLandColumns;
    columns.push_back({"objectsVisible", ofObjects<&ObjectFigures::visible>, true, false});
    columns.push_back({"objectsDrawn", ofObjects<&ObjectFigures::drawn>, true, false});
    columns.push_back({"objectsSwitching", ofObjects<&ObjectFigures::switching>, true, false});
    columns.push_back({"objectTriangles", ofObjects<&ObjectFigures::triangles>, true, false});
    columns.push_back({"objectCullMs", ofObjects<&ObjectFigures::cullMs>, false, true});
    return columns;
}

} // namespace

const std::vector<StatisticsColumn>& statisticsColumns(const std::vector<FrameStatistics>& frames)
{
    static const std::vector<StatisticsColumn> all = withObjects();
    const bool hasObjects = std::any_of(frames.begin(), frames.end(),
                                        [](const FrameStatistics& f) { return f.objects.has_value(); });
    return hasObjects ? all : kLandColumns;
}

ColumnSummary summaryOf(std::vector<double> values)
{
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    const std::size_t rank99 = (99 * n + 99) / 100; // rounded up
    return {0.5 * (values[(n - 1) / 2] + values[n / 2]), values[rank99 - 1], values.back(), 0.0};
}

ColumnSummary summaryOf(const std::vector<FrameStatistics>& frames, const StatisticsColumn& column)
{
    std::vector<double> values;
    for (const FrameStatistics& frame : frames)
        values.push_back(column.value(frame));
    const double first = values.empty() ? 0.0 : values.front();
    if (values.size() > 1) values.erase(values.begin());
    ColumnSummary summary = summaryOf(std::move(values));
    summary.first = first;
    return summary;
}

} // namespace trainer
