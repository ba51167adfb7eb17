// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/map/ReadLand.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "MadeMap.h"
#include "TestFolder.h"
#include "worldmaking/land/MapFile.h"

namespace
{

using namespace worldmaking;
using testsupport::TestFolder;

const char* const kGeoJson = R"({"type": "FeatureCollection", "features": [
 {"type": "Feature", "properties": {"highway": "residential", "name": "A"},
  "geometry": {"type": "LineString", "coordinates": [[1.5, 42.5], [1.501, 42.5], [1.502, 42.501]]}},
 {"type": "Feature", "properties": {"highway": "residential"},
  "geometry": {"type": "LineString", "coordinates": [[1.501, 42.5], [1.501, 42.51]]}},
 {"type": "Feature", "properties": {"building": "yes", "other_tags": "\"height\"=>\"7\",\"note\"=>\"a \\\"b\\\"\""},
  "geometry": {"type": "MultiPolygon", "coordinates": [
   [[[1.6, 42.6], [1.601, 42.6], [1.601, 42.601], [1.6, 42.6]], [[1.6004, 42.6002], [1.6006, 42.6002], [1.6006, 42.6004], [1.6004, 42.6002]]],
   [[[1.7, 42.6], [1.701, 42.6], [1.701, 42.601], [1.7, 42.6]]]]}},
 {"type": "Feature", "properties": {"natural": "tree"}, "geometry": {"type": "Point", "coordinates": [1.5, 42.5]}},
 {"type": "Feature", "properties": {}, "geometry": null}]})";

TEST(ReadLand, TakesPointsLinesAndEachOutlineWithItsHoles)
{
    const TestFolder folder("land");
    const auto read = readLand(folder.write("map.geojson", kGeoJson));
    ASSERT_TRUE(read) << read.error().message();
    ASSERT_EQ(read->shapes.size(), 5u);
    EXPECT_EQ(read->unusable, 1u);
    EXPECT_EQ(read->shapes[2].form, ShapeForm::area);
    EXPECT_EQ(read->shapes[2].paths.size(), 2u);
    EXPECT_EQ(read->shapes[2].paths[0].size(), 3u);
    EXPECT_EQ(valueOf(read->shapes[2].tags, "height"), "7");
    EXPECT_EQ(valueOf(read->shapes[2].tags, "note"), "a \"b\"");
    EXPECT_EQ(read->shapes[3].paths.size(), 1u);
    EXPECT_EQ(read->shapes[4].form, ShapeForm::point);
}

TEST(ReadLand, LeavesOutWhatLiesBeyondTheBounds)
{
    const TestFolder folder("land");
    const auto read = readLand(folder.write("map.geojson", kGeoJson), {1.55, 42.0, 1.65, 43.0});
    ASSERT_TRUE(read) << read.error().message();
    ASSERT_EQ(read->shapes.size(), 1u);
    EXPECT_EQ(valueOf(read->shapes[0].tags, "building"), "yes");
}

TEST(ReadLand, LinesThatShareAPlaceShareANode)
{
    const TestFolder folder("land");
    const auto read = readLand(folder.write("map.geojson", kGeoJson));
    ASSERT_TRUE(read);
    const StreetMap streets = streetsOf(*read);
    ASSERT_EQ(streets.ways.size(), 2u);
    EXPECT_EQ(streets.nodes.size(), 4u);
    EXPECT_EQ(streets.ways[0].nodes[1], streets.ways[1].nodes[0]);
}

TEST(ReadLand, GeofabriksClassesAreTags)
{
    const auto tagged = [](ShapeForm form, Tags tags)
    {
        LandShape shape{1, form, {}, std::move(tags)};
        tagsOfClass(shape);
        return shape.tags;
    };
    const Tags house = tagged(ShapeForm::area, {{"fclass", "building"}, {"type", "church"}});
    EXPECT_EQ(valueOf(house, "building"), "church");
    const Tags street =
        tagged(ShapeForm::line, {{"fclass", "primary"}, {"oneway", "F"}, {"bridge", "T"}, {"tunnel", "F"}});
    EXPECT_EQ(valueOf(street, "highway"), "primary");
    EXPECT_EQ(valueOf(street, "oneway"), "yes");
    EXPECT_EQ(valueOf(street, "bridge"), "yes");
    EXPECT_EQ(valueOf(street, "tunnel"), "no");
    EXPECT_EQ(valueOf(tagged(ShapeForm::line, {{"fclass", "residential"}, {"oneway", "B"}}), "highway"),
              "residential");
    EXPECT_EQ(valueOf(tagged(ShapeForm::area, {{"fclass", "residential"}}), "landuse"), "residential");
    EXPECT_EQ(valueOf(tagged(ShapeForm::area, {{"fclass", "forest"}}), "landuse"), "forest");
    EXPECT_EQ(valueOf(tagged(ShapeForm::area, {{"fclass", "reservoir"}}), "natural"), "water");
    EXPECT_EQ(valueOf(tagged(ShapeForm::line, {{"fclass", "stream"}}), "waterway"), "stream");
}

// The form of a shape is known by its geometry alone: streets, and above all residential ones, were none.
TEST(ReadLand, GeofabriksLinesAreStreetsAndStreams)
{
    const auto feature = [](const char* properties, const char* geometry)
    {
        return std::string(R"({"type": "Feature", "properties": )") + properties + R"(, "geometry": )" +
               geometry + "}";
    };
    const char* const line = R"({"type": "LineString", "coordinates": [[1.5, 42.5], [1.51, 42.51]]})";
    const std::string text =
        R"({"type": "FeatureCollection", "features": [)" +
        feature(R"({"fclass": "residential", "oneway": "B", "maxspeed": 30})", line) + "," +
        feature(R"({"fclass": "secondary", "oneway": "F", "bridge": "T"})", line) + "," +
        feature(R"({"fclass": "stream", "width": 0})", line) + "," +
        feature(
            R"({"fclass": "residential"})",
            R"({"type": "Polygon", "coordinates": [[[1.5, 42.5], [1.51, 42.5], [1.51, 42.51], [1.5, 42.5]]]})") +
        "]}";
    const TestFolder folder("land");
    const auto read = readLand(folder.write("roads.geojson", text));
    ASSERT_TRUE(read) << read.error().message();
    const StreetMap streets = streetsOf(*read);
    ASSERT_EQ(streets.ways.size(), 2U);
    EXPECT_EQ(valueOf(streets.ways[0].tags, "highway"), "residential");
    EXPECT_EQ(valueOf(streets.ways[0].tags, "oneway"), "no");
    EXPECT_EQ(valueOf(streets.ways[1].tags, "oneway"), "yes");
    ASSERT_EQ(read->shapes.size(), 4U);
    EXPECT_EQ(valueOf(read->shapes[2].tags, "waterway"), "stream");
    EXPECT_EQ(valueOf(read->shapes[3].tags, "landuse"), "residential");
}

TEST(ReadLand, SaysWhatIsWrong)
{
    const TestFolder folder("land");
    const auto messageOf = [&](const char* name, const std::string& text)
    {
        const auto read = readLand(folder.write(name, text));
        return read ? std::string("read") : read.error().message();
    };
    EXPECT_NE(messageOf("none.geojson", "{\"type\": \"Feat").find("none.geojson: cannot be read as a map"),
              std::string::npos);
    EXPECT_NE(messageOf("map.gpkg", "no").find("map.gpkg"), std::string::npos);
    const auto missing = readLand(folder / "missing.osm");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().message().find("no such file"), std::string::npos);
}

TEST(MapFile, IsReadBackAndHasTheSameBytesEachTime)
{
    const TestFolder folder("land");
    for (const char* name : {"a.gpkg", "b.gpkg"})
    {
        MapFile file(folder / name);
        file.beginLayer("areas", ShapeForm::area, {"kind"});
        file.add({{{1.5, 42.5}, {1.6, 42.5}, {1.6, 42.6}}}, {{"kind", "field"}, {"other", "unheeded"}});
        file.beginLayer("points", ShapeForm::point, {"kind"});
        file.add({{{1.5, 42.5}}}, {{"kind", "oak"}});
        const auto finished = file.finish();
        ASSERT_TRUE(finished) << finished.error().message();
    }
    EXPECT_EQ(testsupport::bytesOf(folder / "a.gpkg"), testsupport::bytesOf(folder / "b.gpkg"));
    const auto read = readLand(folder / "a.gpkg");
    ASSERT_TRUE(read) << read.error().message();
    ASSERT_EQ(read->shapes.size(), 2u);
    EXPECT_EQ(valueOf(read->shapes[1].tags, "kind"), "oak");
    MapFile nowhere(folder / "none/c.gpkg");
    nowhere.beginLayer("areas", ShapeForm::area, {"kind"});
    EXPECT_FALSE(nowhere.finish());
}

} // namespace
