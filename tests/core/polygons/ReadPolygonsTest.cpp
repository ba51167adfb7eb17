// SPDX-License-Identifier: Apache-2.0
#include "pmtool/polygons/ReadPolygons.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

TEST(ReadPolygons, ObjHasFacesOfAnyNumberOfCorners)
{
    const auto set =
        pmtool::parseObj("# a comment\r\nv 0 0 0\nv 1 0 0 1\nv 1 1 0\nv 0 1 0\nvt 0.5 0.25\nvn 0 0 1\n"
                         "usemtl grass\nf -4 -3 \\\n -2 -1\nf 1/1 2/1/1 3/-1\nf 1//1 2//1 3//1",
                         "a.obj");
    ASSERT_TRUE(set) << set.error().message();
    ASSERT_EQ(set->polygons.size(), 3u);
    EXPECT_THAT(set->polygons[0].corners, ElementsAre(0, 1, 2, 3));
    EXPECT_EQ(set->polygons[0].location, "line 9");
    EXPECT_FALSE(set->polygons[0].isTextured);
    EXPECT_TRUE(set->polygons[1].isTextured);
    EXPECT_EQ(set->texCoords[set->polygons[1].corners[2]], glm::dvec2(0.5, 0.25));
    EXPECT_THAT(set->polygons[2].corners, ElementsAre(0, 1, 2)) << "the same vertices as of the first face";
}

TEST(ReadPolygons, ObjNamesTheLineOfAnError)
{
    for (const char* text :
         {"v 1 2\n", "\nv 1 2 x\n", "v 1 2 inf\n", "v 0 0 0\nf 1 1\n", "v 0 0 0\nf 1 1 0\n",
          "v 0 0 0\nf 1 1 -2\n", "v 0 0 0\nf 1 1 1/1\n", "vt\n", "f 99999999999999999999 1 1\n"})
    {
        const auto set = pmtool::parseObj(text, "a.obj");
        ASSERT_FALSE(set) << text;
        EXPECT_THAT(set.error().place, HasSubstr("a.obj, line ")) << text;
    }
}

TEST(ReadPolygons, GeoJsonHasHolesAndCollections)
{
    const auto set = pmtool::parseGeoJson(
        R"({"type": "GeometryCollection", "geometries": [{"type": "Point", "coordinates": [1, 2]},
            {"type": "MultiPolygon", "coordinates": [[[[0,0],[9,0],[0,9],[0,0]], [[1,1],[2,1],[1,2]]],
                                                     [[[0,0,5],[1,0,5],[0,1,5],[0,0,5]]]]}]})",
        "a.geojson");
    ASSERT_TRUE(set) << set.error().message();
    ASSERT_EQ(set->polygons.size(), 2u);
    EXPECT_THAT(set->polygons[0].contourSizes, ElementsAre(3, 3));
    EXPECT_EQ(set->positions[set->polygons[1].corners[2]], glm::dvec3(0, 1, 5));
    EXPECT_EQ(set->polygons[1].location, "geometries[1]");
}

TEST(ReadPolygons, GeoJsonNamesTheFeatureOfAnError)
{
    for (const char* text :
         {"", "null", "[]", "{}", R"({"type": "Feature"})", R"({"type": "FeatureCollection"})",
          R"({"type": "Polygon"})", R"({"type": "Polygon", "coordinates": [[[0,0],[1,0],[0,0]]]})",
          R"({"type": "Polygon", "coordinates": [[[0,0],[1,"0"],[0,1]]]})",
          R"({"type": "Polygon", "coordinates": [1]})", R"({"type": "MultiPolygon", "coordinates": 1})"})
    {
        const auto set = pmtool::parseGeoJson(text, "a.geojson");
        if (std::string(text).find("\"Feature\"") != std::string::npos)
            EXPECT_TRUE(set && set->polygons.empty()) << "a feature may have no geometry";
        else
            EXPECT_FALSE(set) << text;
    }
    const auto set =
        pmtool::parseGeoJson(R"({"type": "FeatureCollection", "features": [null, {"type": 1}]})", "a");
    ASSERT_FALSE(set);
    EXPECT_EQ(set.error().place, "a, features[1]");
    std::string deep = R"({"type": "Point"})";
    for (int i = 0; i < 1000; ++i)
        deep = R"({"type": "GeometryCollection", "geometries": [)" + deep + "]}";
    EXPECT_FALSE(pmtool::parseGeoJson(deep, "a"));
}

} // namespace
