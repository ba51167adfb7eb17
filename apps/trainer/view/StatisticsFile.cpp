// SPDX-License-Identifier: Apache-2.0
#include "view/StatisticsFile.h"

#include <cstdint>

#include <nlohmann/json.hpp>

#include <viewlod/WholeFile.h>

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

Json frameObject(const FrameStatistics& frame, bool withTimings)
{
    Json object = {{"frame", frame.frame}, {"timeS", frame.timeS}};
    for (const StatisticsColumn& column : statisticsColumns())
        if (withTimings || !column.isMeasured)
            object[std::string(column.name)] = numberOf(column.value(frame), column.isWhole);
    return object;
}

} // namespace

std::string statisticsJson(const std::vector<FrameStatistics>& frames, bool withTimings)
{
    Json root = {{"frames", Json::array()}, {"summary", {{"frames", frames.size()}}}};
    for (const FrameStatistics& frame : frames)
        root["frames"].push_back(frameObject(frame, withTimings));
    for (const StatisticsColumn& column : statisticsColumns())
    {
        if (!withTimings && column.isMeasured) continue;
        const ColumnSummary summary = summaryOf(frames, column);
        root["summary"][std::string(column.name)] = {
            {"median", summary.median}, {"p99", summary.p99}, {"max", summary.largest}};
    }
    return root.dump(1) + "\n";
}

viewlod::Outcome writeStatistics(const std::vector<FrameStatistics>& frames,
                                 const std::filesystem::path& file)
{
    return viewlod::writeWholeFile(file, statisticsJson(frames));
}

} // namespace trainer
