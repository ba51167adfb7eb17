// SPDX-License-Identifier: Apache-2.0
#include "view/StatisticsFile.h"

#include <cstdint>

#include <foundation/WholeFile.h>
#include <nlohmann/json.hpp>

namespace trainer
{

namespace
{

using Json = nlohmann::ordered_json;

Json numberOf(double value, bool isWhole)
{
    if (isWhole) return static_cast<std::uint64_t>(value);
    return value;
}

/// Returns the figures of each selection method that some object uses.
Json methodsObject(const osgPMObjects::core::SelectionStatistics& selection)
{
    using namespace osgPMObjects::core;
    Json object = Json::object();
    for (std::size_t i = 0; i < kSelectionMethods; ++i)
    {
        const auto method = static_cast<SelectionMethod>(i);
        const MethodStatistics& did = selection.of(method);
        if (did.objects == 0) continue;
        Json& row = object[nameOf(method)];
        row = {{"objects", did.objects},    {"switched", did.switched}, {"clamped", did.clamped},
               {"fullArea", did.fullArea},  {"faded", did.faded},       {"gone", did.gone},
               {"triangles", did.triangles}};
        if (method != SelectionMethod::budget) continue;
        row["cost"] = selection.budget.cost;
        row["fits"] = selection.budget.fits;
        row["refused"] = selection.budget.refused;
    }
    return object;
}

Json frameObject(const FrameStatistics& frame, const std::vector<StatisticsColumn>& columns, bool withTimings)
{
    Json object = {{"frame", frame.frame}, {"timeS", frame.timeS}};
    for (const StatisticsColumn& column : columns)
        if (withTimings || !column.isMeasured)
            object[std::string(column.name)] = numberOf(column.value(frame), column.isWhole);
    if (frame.objects) object["objectMethods"] = methodsObject(frame.objects->selection);
    return object;
}

Json openingArray(const std::vector<OpeningStage>& opening)
{
    Json rows = Json::array();
    for (const OpeningStage& stage : opening)
        rows.push_back(
            {{"stage", std::string(stage.name)}, {"wallS", stage.wallS}, {"processorS", stage.processorS}});
    return rows;
}

} // namespace

std::string statisticsJson(const std::vector<FrameStatistics>& frames, bool withTimings,
                           const std::vector<OpeningStage>& opening)
{
    Json root = {{"frames", Json::array()}, {"summary", {{"frames", frames.size()}}}};
    const std::vector<StatisticsColumn>& columns = statisticsColumns(frames);
    for (const FrameStatistics& frame : frames)
        root["frames"].push_back(frameObject(frame, columns, withTimings));
    for (const StatisticsColumn& column : columns)
    {
        if (!withTimings && column.isMeasured) continue;
        const ColumnSummary summary = summaryOf(frames, column);
        root["summary"][std::string(column.name)] = {{"first", summary.first},
                                                     {"median", summary.median},
                                                     {"p99", summary.p99},
                                                     {"max", summary.largest}};
    }
    if (withTimings && !opening.empty()) root["opening"] = openingArray(opening);
    return root.dump(1) + "\n";
}

foundation::Outcome writeStatistics(const std::vector<FrameStatistics>& frames,
                                    const std::vector<OpeningStage>& opening,
                                    const std::filesystem::path& file)
{
    return foundation::writeWholeFile(file, statisticsJson(frames, true, opening));
}

} // namespace trainer
