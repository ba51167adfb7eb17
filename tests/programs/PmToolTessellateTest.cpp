// SPDX-License-Identifier: Apache-2.0
// `pmtool tessellate` as somebody runs it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <sstream>
#include <vector>

#include <gdal_priv.h>

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

/// A trapezoid that shows a whole texture, and a picture of 64 x 64 texels whose red rises to the right.
constexpr const char* kTrapezoid = "v -1 0 0\nv 1 0 0\nv .5 1 0\nv -.5 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                                   "f 1/1 2/2 3/3 4/4\n";

std::string risingPicture()
{
    std::string ppm = "P6\n64 64\n255\n";
    for (int row = 0; row < 64; ++row)
        for (int column = 0; column < 64; ++column)
            ppm += {static_cast<char>(4 * column), '\0', '\0'};
    return ppm;
}

/// The reds of a picture, row by row from above.
std::vector<std::uint8_t> redsOf(const std::string& file)
{
    const std::unique_ptr<GDALDataset> picture(GDALDataset::Open(file.c_str()));
    if (!picture) return {};
    std::vector<std::uint8_t> reds(64 * 64);
    EXPECT_EQ(picture->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, 64, 64, reds.data(), 64, 64, GDT_Byte, 0, 0,
                                                  nullptr),
              CE_None);
    return reds;
}

TEST(PmToolTessellate, WarpsATextureForTwoTrianglesAQuad)
{
    const Workplace place;
    const std::string file = place.write("roof.obj", kTrapezoid),
                      texture = place.write("rising.ppm", risingPicture());
    const auto row = pmToolTable(place, {"tessellate", file, "--warped", "pre", "--texture", texture,
                                         "--output", place.path("cut")})["models"][0];
    EXPECT_EQ(row["triangles"], 2);
    EXPECT_EQ(row["warpedQuads"], 1);
    EXPECT_EQ(row["refusedQuads"], 0);
    const std::string obj = readBytes(place.path("cut/roof.obj"));
    EXPECT_TRUE(obj.starts_with("mtllib roof.mtl\nusemtl warped\n")) << obj;
    EXPECT_NE(readBytes(place.path("cut/roof.mtl")).find("map_Kd roof.png\n"), std::string::npos);
    const auto reds = redsOf(place.path("cut/roof.png"));
    ASSERT_EQ(reds.size(), 64u * 64u);
    // The trapezoid is 2 - v wide at the height v; each triangle maps its texels affinely.
    double most = 0.0;
    for (int up = 0; up < 64; ++up)
        for (int column = 0; column < 64; ++column)
        {
            const double u = (column + 0.5) / 64.0, v = (up + 0.5) / 64.0;
            const double x = u >= v ? 2.0 * u - 0.5 * v - 1.0 : u + 0.5 * v - 1.0;
            const double share = x / (2.0 - v) + 0.5;
            const int red = reds[static_cast<std::size_t>((63 - up) * 64 + column)];
            EXPECT_NEAR(red, std::clamp(256.0 * share - 2.0, 0.0, 252.0), 3.0) << column << ' ' << up;
            most = std::max(most, std::abs(share - u));
        }
    EXPECT_GT(most, 0.1); // it is not the picture that was given
}

TEST(PmToolTessellate, WritesProjectiveCoordinates)
{
    const Workplace place;
    const std::string file = place.write("roof.obj", kTrapezoid);
    const auto row = pmToolTable(
        place, {"tessellate", file, "--warped", "projective", "--output", place.path("cut")})["models"][0];
    EXPECT_EQ(row["triangles"], 2);
    EXPECT_EQ(row["warpedQuads"], 1);
    std::istringstream lines(readBytes(place.path("cut/roof.obj")));
    int divided = 0;
    for (std::string line, key; std::getline(lines, line);)
    {
        std::istringstream words(line);
        double u = 0.0, v = 0.0, q = 0.0;
        if (words >> key >> u >> v >> q; key != "vt" || q == 1.0) continue;
        ++divided;
        EXPECT_TRUE(u == 0.0 || std::abs(u - q) < 1e-12) << line;
        EXPECT_TRUE(v == 0.0 || std::abs(v - q) < 1e-12) << line;
    }
    EXPECT_EQ(divided, 4);
}

TEST(PmToolTessellate, SaysWhatDoesNotGoWithWarpedQuads)
{
    const Workplace place;
    const std::string file = place.write("roof.obj", kTrapezoid),
                      texture = place.write("rising.ppm", risingPicture());
    const auto fails = [&](Words more, int code, const Words& words)
    {
        more.insert(more.begin(), {"tessellate", file});
        return failsWith(runPmTool(more), code, "pmtool", words);
    };
    EXPECT_TRUE(fails({"--warped", "post"}, 2, {"--warped", "'post'", "projective"}));
    EXPECT_TRUE(fails({"--warped", "2"}, 2, {"--warped", "'2'"}));
    EXPECT_TRUE(fails({"--warped", "pre"}, 2, {"--warped pre", "--texture"}));
    EXPECT_TRUE(fails({"--texture", texture}, 2, {"--texture", "--warped pre"}));
    EXPECT_TRUE(fails({"--warped", "projective", "--uniform", "1"}, 2, {"--uniform"}));
    EXPECT_TRUE(fails({"--warped", "pre", "--texture", "/nowhere.png"}, 1, {"/nowhere.png"}));
    const std::string twice = place.write("twice.obj", std::string(kTrapezoid) + "f 1/1 2/2 3/3\n");
    EXPECT_TRUE(failsWith(runPmTool({"tessellate", twice, "--warped", "pre", "--texture", texture}), 1,
                          "pmtool", {"twice.obj, line 10", "line 9"}));
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
