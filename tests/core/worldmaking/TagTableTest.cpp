// SPDX-License-Identifier: Apache-2.0
// The table of tags: what the page says, and what is told of a map.
#include "worldmaking/map/TagTable.h"

#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "TestFolder.h"
#include "worldmaking/land/TagReport.h"

namespace
{

using namespace worldmaking;

/// The rows | `key` | use | … | of the page.
std::vector<std::pair<std::string, std::string>> rowsOfPage()
{
    std::istringstream page(
        testsupport::bytesOf(std::string(OSGTRAINER_SOURCE_DIR) + "/docs/reference/map-tags.md"));
    std::vector<std::pair<std::string, std::string>> rows;
    for (std::string line; std::getline(page, line);)
    {
        if (!line.starts_with("| `")) continue;
        const std::size_t end = line.find('`', 3), bar = line.find("| ", end);
        const std::size_t stop = line.find(" |", bar);
        rows.emplace_back(line.substr(3, end - 3), line.substr(bar + 2, stop - bar - 2));
    }
    return rows;
}

TEST(TagTable, ThePageHasTheTagsOfTheCode)
{
    std::vector<std::pair<std::string, std::string>> tags;
    for (const KnownTag& tag : knownTags())
        tags.emplace_back(tag.key, tag.use == TagUse::read      ? "read"
                                   : tag.use == TagUse::ignored ? "ignored"
                                                                : "approximated");
    EXPECT_EQ(rowsOfPage(), tags);
    EXPECT_GT(tags.size(), 80u);
}

TEST(TagTable, ValuesThatCannotBeReadAreCountedOnOneLine)
{
    LandMap map;
    const auto add = [&](Tags tags)
    {
        LandShape shape;
        shape.form = ShapeForm::line;
        shape.tags = std::move(tags);
        map.shapes.push_back(std::move(shape));
    };
    add({{"building", "yes"}, {"height", "tall"}, {"building:levels", "7"}});
    add({{"building", "yes"}, {"height", "tall"}, {"roof:height", "2 m"}, {"min_height", "none"}});
    add({{"highway", "primary"}, {"lanes", "many"}, {"maxspeed", "signals"}, {"width", "36'2\""}});
    add({{"highway", "primary"}, {"lanes", "2;3"}, {"maxspeed", "DE:urban"}, {"oneway", "reversible"}});
    add({{"highway", "proposed"}, {"lanes", "2;3"}});
    const TagReport report = tagReportOf(map);
    EXPECT_EQ(report.passedOver, (TagCounts{{"height=tall", 2}, {"lanes=many", 1}, {"min_height=none", 1}}));
    EXPECT_EQ(report.approximated, (TagCounts{{"lanes=2;3", 1}, {"oneway=reversible", 1}}));
    EXPECT_EQ(lineOf(report.passedOver), "height=tall 2, lanes=many 1, min_height=none 1");
    EXPECT_EQ(lineOf({}), "");
    TagCounts many;
    for (int i = 0; i < 100; ++i)
        countTag(&many, {{"height", std::string(1000, 'a') + std::to_string(i)}}, "height");
    EXPECT_LE(many.size(), kMostTagCounts + 1);
    EXPECT_LT(lineOf(many).size(), 1000u);
}

} // namespace
