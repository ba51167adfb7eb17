// SPDX-License-Identifier: Apache-2.0
// Maps as they are read: what is kept, and what is told of bad ones.
#include "worldmaking/map/ReadOsm.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "MadeMap.h"
#include "worldmaking/map/ReadLand.h"

namespace
{

using worldmaking::parseOsm;
using worldmaking::StreetMap;

TEST(ReadOsm, KeepsStreetsWithTheirNodesAndTurnRules)
{
    MadeMap made;
    const int a = made.node(0, 0), b = made.node(100, 0), c = made.node(100, 50);
    made.node(500, 500); // of no street
    const int street = made.way({a, b}, {{"highway", "primary"}, {"name", "Alt &amp; Neu"}});
    const int other = made.way({b, c});
    made.way({a, c}, {{"waterway", "river"}});
    made.rule("no_left_turn", street, b, other);
    const auto map = parseOsm(made.text(), "osm", "made.osm");
    ASSERT_TRUE(map) << map.error().message();
    ASSERT_EQ(map->ways.size(), 2u);
    EXPECT_EQ(map->nodes.size(), 3u);
    EXPECT_EQ(worldmaking::valueOf(map->ways[0].tags, "name"), "Alt & Neu");
    EXPECT_NEAR(map->nodes[1].longitudeDeg,
                1.5 + 100.0 / (111000.0 * std::cos(42.5 * 3.14159265358979 / 180.0)), 1e-6);
    ASSERT_EQ(map->turnRules.size(), 1u);
    EXPECT_EQ(map->turnRules[0].via, b);
    EXPECT_FALSE(map->turnRules[0].isOnly);
}

TEST(ReadOsm, WaysGoOnWithoutNodesThatAreMissing)
{
    MadeMap made;
    const int a = made.node(0, 0), b = made.node(100, 0);
    made.way({a, 77, b});
    made.way({a, 78});
    const auto map = parseOsm(made.text(), "osm", "made.osm");
    ASSERT_TRUE(map) << map.error().message();
    EXPECT_EQ(map->ways.size(), 1u);
    EXPECT_EQ(map->ways[0].nodes.size(), 2u);
    EXPECT_EQ(map->missingNodes, 2u);
    EXPECT_EQ(map->shortWays, 1u);
}

TEST(ReadOsm, TellsWhatIsWrong)
{
    using testing::HasSubstr;
    const auto messageOf = [](const std::string& text, const char* format)
    {
        const auto map = parseOsm(text, format, "bad");
        return map ? std::string("it was read") : map.error().message();
    };
    EXPECT_EQ(messageOf("<osm version=\"0.6\"/>", "osm"), "it was read"); // a map may have no street
    EXPECT_THAT(messageOf("<osm version=\"0.6\"><way id=\"1\"", "osm"), HasSubstr("bad: cannot be read"));
    EXPECT_THAT(messageOf("no map at all", "osm"), HasSubstr("check that it is complete"));
    EXPECT_THAT(messageOf("no map at all", "pbf"), HasSubstr("check that it is complete"));
    MadeMap made;
    made.way({8, 9});
    EXPECT_THAT(messageOf(made.text(), "osm"), HasSubstr("its streets have no nodes"));
}

/// The parsers of libosmium and GDAL know four encodings; the file may have any.
TEST(ReadOsm, NamesAreWholeInAnyEncoding)
{
    const std::string body =
        "<osm version='0.6'><node id='1' lat='42.5' lon='1.5'/><node id='2' lat='42.51' lon='1.5'/>"
        "<way id='9'><nd ref='1'/><nd ref='2'/><tag k='highway' v='primary'/><tag k='name' v='";
    const auto head = [](const char* encoding)
    { return "<?xml version='1.0' encoding='" + std::string(encoding) + "'?>\n"; };
    const std::string end = "'/></way></osm>";
    struct Case
    {
        std::string bytes, name;
    };
    std::string wide = "\xFF\xFE";
    for (const char c : head("UTF-16") + body + "Rue" + end)
        wide += {c, '\0'};
    for (const Case& one : {Case{head("windows-1252") + body +
                                     "Stra\xDF"
                                     "e \x80" +
                                     end,
                                 "Stra\xC3\x9F"
                                 "e \xE2\x82\xAC"},
                            Case{head("ISO-8859-15") + body + "\xA4" + end, "\xE2\x82\xAC"},
                            Case{head("ISO-8859-1") + body + "\xC9t\xE9" + end, "\xC3\x89t\xC3\xA9"},
                            Case{head("KOI8-R") + body + "\xCD" + end, "\xD0\xBC"}, Case{wide, "Rue"},
                            Case{head("utf-8") + body + "\xC3\x89" + end, "\xC3\x89"}})
    {
        const auto file = std::filesystem::path(testing::TempDir()) / "encoded.osm";
        std::ofstream(file, std::ios::binary) << one.bytes;
        const auto map = worldmaking::readOsm(file);
        ASSERT_TRUE(map) << map.error().message();
        ASSERT_EQ(map->ways.size(), 1u);
        EXPECT_EQ(worldmaking::valueOf(map->ways[0].tags, "name"), one.name);
        const auto land = worldmaking::readLand(file, {1.0, 42.0, 2.0, 43.0});
        ASSERT_TRUE(land) << land.error().message();
        ASSERT_EQ(land->shapes.size(), 1u);
        EXPECT_EQ(worldmaking::valueOf(land->shapes[0].tags, "name"), one.name);
        std::filesystem::remove(file);
    }
}

} // namespace
