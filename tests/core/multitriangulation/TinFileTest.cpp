// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>

#include <gtest/gtest.h>

#include <osgMultiTriangulation/core/check/SurfaceCheck.h>
#include <osgMultiTriangulation/core/input/TinFile.h>

#include "RealData.h"
#include "TestFolder.h"

namespace osgMultiTriangulation::core
{

namespace
{

const std::string kRoof = "# a roof\nv 0 0 5\nv 10 0 5\nv 10.5 20 5\nv 0 20 5\nv 5 10 9 # ridge\nvn 0 0 1\n"
                          "f 1 2 5\nf 2//1 3/1/1 5\r\nf 3 4 -1\nf 1 5 4\n";

template<class T>
void add(std::string& bytes, T value)
{
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
}

TEST(TinFile, objIsReadWithFansAndNumbersFromTheEnd)
{
    const auto tin = parseObj(kRoof + "f 1 2 3 4\n", "roof.obj");
    ASSERT_TRUE(tin) << tin.error().message();
    ASSERT_EQ(tin->points.size(), 5u);
    EXPECT_EQ(tin->points[4], (MeasuredPoint{5, 10, 9}));
    ASSERT_EQ(tin->triangles.size(), 6u);
    EXPECT_EQ(tin->triangles[2], (Triangle{2, 3, 4}));
    EXPECT_EQ(tin->triangles[5], (Triangle{0, 2, 3}));
}

TEST(TinFile, objNamesTheLineThatIsWrong)
{
    for (const auto& [text, line] :
         std::vector<std::pair<std::string, std::string>>{{kRoof + "v 1 2\n", ":12"},
                                                          {kRoof + "f 1 2 9\n", ":12"},
                                                          {"v 1 2 nan\n", ":1"},
                                                          {kRoof + "f 1 2\n", ":12"}})
    {
        const auto tin = parseObj(text, "roof.obj");
        ASSERT_FALSE(tin) << text;
        EXPECT_EQ(tin.error().place, "roof.obj" + line);
    }
    EXPECT_FALSE(parseObj("v 1 2 3\n", "points.obj"));
}

std::string plyHeader(const std::string& form, const std::string& real)
{
    return "ply\nformat " + form + " 1.0\ncomment a square\nelement vertex 4\nproperty " + real +
           " x\nproperty " + real + " y\nproperty uchar red\nproperty " + real +
           " z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
}

TEST(TinFile, plyIsReadAsTextAndInBinaryOfBothOrders)
{
    const double places[4][3] = {{0, 0, 1}, {8, 0, 2.5}, {8, 8, 3}, {0, 8, -4}};
    std::string text = plyHeader("ascii", "float"), little = plyHeader("binary_little_endian", "double");
    std::string big = plyHeader("binary_big_endian", "double");
    const auto reversed = [](double value)
    {
        auto bits = std::bit_cast<std::array<char, 8>>(value);
        std::ranges::reverse(bits);
        return std::bit_cast<double>(bits);
    };
    for (const auto& p : places)
    {
        text += std::to_string(p[0]) + " " + std::to_string(p[1]) + " 200 " + std::to_string(p[2]) + "\n";
        for (const int axis : {0, 1, -1, 2})
        {
            if (axis < 0)
                little += 'r', big += 'r';
            else
                add(little, p[axis]), add(big, reversed(p[axis]));
        }
    }
    text += "4 0 1 2 3\n";
    little += '\4', big += '\4';
    for (const int corner : {0, 1, 2, 3})
        add(little, corner), add(big, std::uint32_t(corner) << 24);
    for (const std::string& file : {text, little, big})
    {
        const auto tin = parsePly(file, "square.ply");
        ASSERT_TRUE(tin) << tin.error().message();
        ASSERT_EQ(tin->points.size(), 4u);
        for (int i = 0; i < 4; ++i)
            EXPECT_EQ(tin->points[i], (MeasuredPoint{places[i][0], places[i][1], places[i][2]}));
        EXPECT_EQ(tin->triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
        for (std::size_t length = 0; length + 2 < file.size(); length += 7)
            EXPECT_FALSE(parsePly(std::string_view(file).substr(0, length), "square.ply")) << length;
    }
    text.replace(text.rfind('3'), 1, "4");
    EXPECT_FALSE(parsePly(text, "square.ply"));
}

TEST(TinFile, aTileOfQuantizedMeshIsReadWhereItLies)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "dem/quantized-mesh");
    int tiles = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
    {
        if (entry.path().extension() != ".terrain") continue;
        const auto tin = readTinFile(entry.path());
        ASSERT_TRUE(tin) << tin.error().message();
        const auto placed = placeTin(*tin, entry.path().string());
        ASSERT_TRUE(placed) << placed.error().message();
        EXPECT_EQ(placed->mesh.triangles.size(), tin->triangles.size());
        EXPECT_EQ(checkInput(placed->mesh), std::nullopt);
        ++tiles;
        const std::string bytes = testsupport::bytesOf(entry.path());
        for (std::size_t length = 0; length < std::min<std::size_t>(bytes.size(), 900); length += 31)
            EXPECT_FALSE(parseQuantizedMesh(std::string_view(bytes).substr(0, length), "cut")) << length;
    }
    EXPECT_EQ(tiles, 3);
}

TEST(TinFile, placesAreOneSurface)
{
    const auto tin = parseObj(kRoof, "roof.obj");
    const auto placed = placeTin(*tin, "roof.obj");
    ASSERT_TRUE(placed) << placed.error().message();
    EXPECT_EQ(placed->frame.stepX, 0.1);
    EXPECT_EQ(placed->mesh.points[2], (SurfacePoint{105, 200, 5.0}));
    EXPECT_EQ(placed->mostMoved, 0.0);
    EXPECT_EQ(checkInput(placed->mesh), std::nullopt);
    MeasuredTin turned = *tin;
    std::swap(turned.triangles[1][0], turned.triangles[1][1]);
    EXPECT_EQ(checkInput(placeTin(turned, "roof.obj")->mesh), std::nullopt);
    MeasuredTin split = *tin; // each triangle with vertices of its own
    split.points.clear();
    for (Triangle& triangle : split.triangles)
        for (std::uint32_t& corner : triangle)
        {
            split.points.push_back(tin->points[corner]);
            corner = static_cast<std::uint32_t>(split.points.size() - 1);
        }
    EXPECT_EQ(placeTin(split, "roof.obj")->mesh.points.size(), 5u);
}

TEST(TinFile, wallsAndNeedlesAreRefused)
{
    const auto wall = placeTin(*parseObj(kRoof + "v 0 0 0\nf 1 2 6\n", "wall"), "wall.obj");
    ASSERT_FALSE(wall);
    EXPECT_NE(wall.error().what.find("two heights"), std::string::npos);
    const auto needle = placeTin(*parseObj(kRoof + "v 5 0 5\nf 1 2 6\n", "needle"), "needle.obj");
    ASSERT_FALSE(needle);
    EXPECT_NE(needle.error().what.find("no area"), std::string::npos);
}

} // namespace

} // namespace osgMultiTriangulation::core
