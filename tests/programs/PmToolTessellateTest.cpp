// SPDX-License-Identifier: Apache-2.0
// `pmtool tessellate` as somebody runs it.
#include <array>
#include <sstream>

#include "PmToolRun.h"

namespace
{

/// A square of side 4 with a square hole of side 2, as GeoJSON.
constexpr const char* kFrame = R"({"type": "FeatureCollection", "features": [{"type": "Feature", "geometry":
    {"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,4],[0,4],[0,0]], [[1,1],[3,1],[3,3],[1,3],[1,1]]]}}]})";

/// An L of six corners, and a textured quad that is no parallelogram.
constexpr const char* kFaces = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 4 0 0\nv 3 1 0\n"
                               "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1 2 3 4 5 6\nf 2/1 7/2 8/3 3/4\n";

/// The area of all faces of a plain .obj in the plane z = 0.
double areaOf(const std::string& obj)
{
    std::istringstream lines(obj);
    std::vector<std::array<double, 2>> vertices;
    double area = 0.0;
    for (std::string line; std::getline(lines, line);)
    {
        std::istringstream words(line);
        std::string key;
        words >> key;
        if (key == "v") words >> vertices.emplace_back()[0] >> vertices.back()[1];
        if (key != "f") continue;
        std::vector<std::array<double, 2>> corners;
        for (std::string word; words >> word;)
            corners.push_back(vertices.at(std::stoul(word) - 1));
        for (std::size_t i = 0; i < corners.size(); ++i)
        {
            const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
            area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
        }
    }
    return area;
}

TEST(PmToolTessellate, CutsAHoleOutOfGeoJson)
{
    const Workplace place;
    const std::string file = place.write("frame.geojson", kFrame);
    const auto table = pmToolTable(place, {"tessellate", file, "--output", place.path("cut")});
    const auto& row = table["models"][0];
    EXPECT_EQ(keysOf(row), (Words{"model", "polygons", "corners", "holes", "triangles", "vertices",
                                  "inserted", "crossings", "unusedCorners", "bridges", "ms", "output"}));
    EXPECT_EQ(row["holes"], 1);
    EXPECT_EQ(row["triangles"], 8);
    EXPECT_NEAR(areaOf(readBytes(place.path("cut/frame.obj"))), 12.0, 1e-12);
}

TEST(PmToolTessellate, CutsFacesToConvexPieces)
{
    const Workplace place;
    const std::string file = place.write("faces.obj", kFaces);
    const auto row =
        pmToolTable(place, {"tessellate", file, "--convex", "--output", place.path("cut")})["models"][0];
    EXPECT_EQ(row["pieces"], 3) << "the L needs two";
    EXPECT_EQ(row["provedLeast"], 2);
    EXPECT_NEAR(areaOf(readBytes(place.path("cut/faces.obj"))), 4.5, 1e-12);
    const auto quick = pmToolTable(place, {"tessellate", file, "--convex", "--quick"})["models"][0];
    EXPECT_EQ(quick["provedLeast"], 0);
}

TEST(PmToolTessellate, HalvesLongEdgesAndKeepsTexturesBilinear)
{
    const Workplace place;
    const std::string file = place.write("faces.obj", kFaces);
    const auto plain = pmToolTable(place, {"tessellate", file})["models"][0];
    EXPECT_EQ(plain["triangles"], 6);
    const auto fine = pmToolTable(
        place, {"tessellate", file, "--uniform", "0.5", "--output", place.path("cut")})["models"][0];
    EXPECT_GT(fine["triangles"], 36);
    EXPECT_NEAR(areaOf(readBytes(place.path("cut/faces.obj"))), 4.5, 1e-12);
    const auto warped = pmToolTable(
        place, {"tessellate", file, "--warped", "0.01", "--output", place.path("warped")})["models"][0];
    EXPECT_EQ(warped["grids"], 1);
    EXPECT_EQ(warped["refusedGrids"], 0);
    EXPECT_GT(warped["triangles"], 8);
    EXPECT_NEAR(areaOf(readBytes(place.path("warped/faces.obj"))), 4.5, 1e-12);
}

TEST(PmToolTessellate, SaysWhatItCannotRead)
{
    const Workplace place;
    const auto fails = [&](const std::string& name, const std::string& text, const Words& words)
    {
        const std::string file = place.write(name, text);
        return failsWith(runPmTool({"tessellate", file}), 1, "pmtool", words);
    };
    EXPECT_TRUE(fails("a.obj", "v 0 0 0\nf 1 2 3\n", {"a.obj, line 2", "'2'"}));
    EXPECT_TRUE(fails("b.obj", "v 0 nan 0\n", {"b.obj, line 1", "finite"}));
    EXPECT_TRUE(fails("c.obj", "v 0 0 0\n", {"c.obj", "no polygons"}));
    EXPECT_TRUE(fails("d.geojson", "{", {"d.geojson", "no JSON"}));
    EXPECT_TRUE(fails("e.txt", "", {"e.txt", ".geojson"}));
    EXPECT_TRUE(failsWith(runPmTool({"tessellate", "/nowhere.obj"}), 1, "pmtool",
                          {"/nowhere.obj", "cannot be read"}));
    const std::string good = place.write("good.obj", kFaces);
    EXPECT_TRUE(failsWith(runPmTool({"tessellate", good, "--uniform", "-1"}), 2, "pmtool", {"--uniform"}));
    EXPECT_TRUE(
        failsWith(runPmTool({"tessellate", good, "--uniform", "1e-6"}), 1, "pmtool", {good, "triangles"}));
    EXPECT_TRUE(failsWith(runPmTool({"tessellate", good, "--quick"}), 2, "pmtool", {"--convex"}));
    EXPECT_TRUE(
        failsWith(runPmTool({"tessellate", good, "--convex", "--warped", "0.1"}), 2, "pmtool", {"--convex"}));
    EXPECT_TRUE(failsWith(runPmTool({"tessellate", good, "--inside", "out"}), 2, "pmtool", {"--inside"}));
}

} // namespace
