// SPDX-License-Identifier: Apache-2.0
#include "view/PartsTable.h"

#include <cstdio>

#include <foundation/WholeFile.h>
#include <nlohmann/json.hpp>

#include "view/FrameStatistics.h"

namespace trainer
{

namespace
{

ColumnSummary summaryOf(const PartCosts& part, double PictureCost::*column)
{
    std::vector<double> values;
    for (const PictureCost& picture : part.pictures)
        values.push_back(picture.*column);
    return trainer::summaryOf(std::move(values));
}

/// The sums of one row of the table.
struct Row
{
    ColumnSummary processor, wall;
    double draws, mapDraws, costsMs;

    Row(const PartCosts& part, const PartCosts& whole)
        : processor(summaryOf(part, &PictureCost::processorMs)),
          wall(summaryOf(part, &PictureCost::wallMs)),
          draws(summaryOf(part, &PictureCost::draws).median),
          mapDraws(summaryOf(part, &PictureCost::mapDraws).median),
          costsMs(summaryOf(whole, &PictureCost::processorMs).median - processor.median)
    {
    }
};

} // namespace

std::string partsText(const std::vector<PartCosts>& parts)
{
    std::string text =
        "without         processor ms p50     p99   wall ms p50     p99   costs  draws  of maps\n";
    for (const PartCosts& part : parts)
    {
        if (part.pictures.empty()) continue;
        const Row row(part, parts.front());
        char line[160];
        std::snprintf(line, sizeof line, "%-15s %16.1f %7.1f %13.1f %7.1f %7.1f %6.0f %8.0f\n",
                      part.without.empty() ? "-" : part.without.c_str(), row.processor.median,
                      row.processor.p99, row.wall.median, row.wall.p99, row.costsMs, row.draws, row.mapDraws);
        text += line;
    }
    return text;
}

foundation::Outcome writeParts(const std::vector<PartCosts>& parts, const std::filesystem::path& file)
{
    nlohmann::ordered_json root = {{"parts", nlohmann::ordered_json::array()}};
    for (const PartCosts& part : parts)
    {
        if (part.pictures.empty()) continue;
        const Row row(part, parts.front());
        root["parts"].push_back({{"without", part.without},
                                 {"pictures", part.pictures.size()},
                                 {"processorMsP50", row.processor.median},
                                 {"processorMsP99", row.processor.p99},
                                 {"wallMsP50", row.wall.median},
                                 {"wallMsP99", row.wall.p99},
                                 {"draws", row.draws},
                                 {"mapDraws", row.mapDraws},
                                 {"costsMs", row.costsMs}});
    }
    return foundation::writeWholeFile(file, root.dump(1) + "\n");
}

} // namespace trainer
