// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/land/TagReport.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "worldmaking/map/TagTable.h"
#include "worldmaking/streets/StreetTraits.h"

namespace worldmaking
{

TagReport tagReportOf(const LandMap& map)
{
    TagReport report;
    for (const LandShape& shape : map.shapes)
    {
        for (const KnownTag& tag : knownTags())
        {
            if (tag.use == TagUse::ignored || tag.value == TagValue::word) continue;
            const std::string_view value = valueOf(shape.tags, tag.key);
            if (!value.empty() && !isReadable(tag, value)) countTag(&report.passedOver, shape.tags, tag.key);
        }
        if (shape.form == ShapeForm::line && !valueOf(shape.tags, "highway").empty())
            (void)traitsOf(shape.tags, &report.approximated);
    }
    return report;
}

std::string lineOf(const TagCounts& counts)
{
    constexpr std::size_t kMostNamed = 6;
    std::vector<std::pair<std::string, std::size_t>> sorted(counts.begin(), counts.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    std::string line;
    for (std::size_t i = 0; i < std::min(sorted.size(), kMostNamed); ++i)
        line += (line.empty() ? "" : ", ") + sorted[i].first + " " + std::to_string(sorted[i].second);
    if (sorted.size() > kMostNamed)
        line += " and " +
                std::to_string(std::accumulate(sorted.begin() + kMostNamed, sorted.end(), std::size_t{0},
                                               [](std::size_t sum, const auto& entry)
                                               { return sum + entry.second; })) +
                " others";
    return line;
}

} // namespace worldmaking
