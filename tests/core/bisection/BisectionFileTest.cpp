// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/bisection/BisectionCheck.h>
#include <osgTerrainROAM/core/bisection/BisectionFile.h>

#include "TestFolder.h"

namespace osgTerrainROAM::core
{

namespace
{

using testing::HasSubstr;

class BisectionFiles : public testing::Test
{
protected:
    std::string messageOf(const std::string& text) const
    {
        const auto opened = openBisection(folder.write("bad.bisection", text));
        return opened ? "" : opened.error().message();
    }

    std::shared_ptr<const BisectionModel> modelOf(const std::string& text) const
    {
        const auto opened = openBisection(folder.write("good.bisection", text));
        EXPECT_TRUE(opened) << opened.error().message();
        return opened ? *opened : nullptr;
    }

    void writeGround() const
    {
        folder.write("ground.obj", "v 0 0 0\nv 100 0 0\nv 100 100 0\nv 0 100 0\nf 1 2 3 4\n");
        folder.write("tower.obj", "v 60 50 0\nv 64 50 8\nv 62 54 0\nf 1 2 3\n");
    }

    testsupport::TestFolder folder{"bisection-file"};
};

} // namespace

TEST_F(BisectionFiles, keysAreRead)
{
    const auto file = parseBisectionFile("# a comment\nmesh = a.obj\nlevels = 7\nrelief = 3 20 # metres\n"
                                         "tin = b.obj\ntin = c.obj\n",
                                         "/folder/x.bisection");
    ASSERT_TRUE(file);
    BisectionFile expected;
    expected.mesh = "/folder/a.obj";
    expected.levels = 7;
    expected.relief = 3.0;
    expected.reliefSize = 20.0;
    expected.tins = {"/folder/b.obj", "/folder/c.obj"};
    EXPECT_EQ(*file, expected);
    expected.levels = 8;
    EXPECT_NE(*file, expected);
}

TEST_F(BisectionFiles, whatIsWrongIsToldWithItsPlace)
{
    writeGround();
    EXPECT_THAT(messageOf("levels = 4\nsize = 3\n"), HasSubstr("bad.bisection:2: unknown key 'size'"));
    EXPECT_THAT(messageOf("levels = 40\n"), HasSubstr("bad.bisection:1"));
    EXPECT_THAT(messageOf("levels = 4\nlevels = 5\n"), HasSubstr("bad.bisection:2: 'levels' stands here a"));
    EXPECT_THAT(messageOf("relief = -1 2\n"), HasSubstr("bad.bisection:1"));
    EXPECT_THAT(messageOf("mesh = a.obj\ndem = b.tif\n"), HasSubstr("a mesh and a dem"));
    EXPECT_THAT(messageOf("radius = 5\ntin = b.obj\n"), HasSubstr("a radius beside"));
    EXPECT_THAT(messageOf("mesh = none.obj\n"), HasSubstr("none.obj"));
    EXPECT_THAT(messageOf("levels = 24\n"), HasSubstr("too many triangles"));
    EXPECT_THAT(messageOf("mesh = ground.obj\ntin = ground.obj\n"), HasSubstr("lies in no triangle"));
    EXPECT_THAT(messageOf("mesh = ground.obj\ntin = tower.obj\ntin = tower.obj\n"),
                HasSubstr("lies in the triangle of another TIN"));
    EXPECT_EQ(messageOf("mesh = ground.obj\ntin = tower.obj\n"), "");
}

TEST_F(BisectionFiles, aSphereHasItsRadiusAndRelief)
{
    const auto range = [&](const std::string& text)
    {
        double least = 1e9, most = 0.0;
        const auto model = modelOf(text);
        model->surface.forEachVertex(
            [&](std::uint32_t vertex)
            {
                least = std::min(least, glm::length(model->surface.point(vertex)));
                most = std::max(most, glm::length(model->surface.point(vertex)));
            });
        return std::pair(least, most);
    };
    const auto [low, high] = range("levels = 6\nradius = 100\n");
    EXPECT_NEAR(low, 100.0, 1e-9);
    EXPECT_NEAR(high, 100.0, 1e-9);
    const auto [valley, peak] = range("levels = 6\nradius = 100\nrelief = 5 40\n");
    EXPECT_LT(valley, 99.0);
    EXPECT_GE(valley, 95.0);
    EXPECT_GT(peak, 101.0);
    EXPECT_LE(peak, 105.0);
    EXPECT_NEAR(range("levels = 6\n").second, std::sqrt(3.0), 1e-9) << "without a radius it is the cube";
}

TEST_F(BisectionFiles, aTinLiesInASmallTriangleOfGroundAndIsDrawnNearIt)
{
    writeGround();
    const auto model = modelOf("mesh = ground.obj\nlevels = 10\ntin = tower.obj\n");
    ASSERT_EQ(model->patches.size(), 1u);
    EXPECT_GE(model->patches[0].carrier.level(), 3);
    BisectionMesh mesh(model->surface, model->patches);
    const BisectionView near{{50.0, 40.0, 10.0}, 0.001, 1.0}, far{{50.0, 40.0, 1e6}, 0.001, 1.0};
    mesh.refine(near);
    EXPECT_TRUE(mesh.isShown(0));
    EXPECT_EQ(checkDrawn(mesh.surface(), mesh.drawn()), std::nullopt);
    EXPECT_LE(worstShare(mesh, near), 1.0 + 1e-9);
    mesh.refine(far);
    EXPECT_FALSE(mesh.isShown(0));
    EXPECT_GT(worstShare(mesh, near), 1.0) << "the tower is missed where it is not drawn";
}

TEST_F(BisectionFiles, ADemIsTheGround)
{
    std::string raster = "ncols 9\nnrows 5\nxllcorner 0\nyllcorner 0\ncellsize 10\n";
    for (int row = 4; row >= 0; --row) // the northernmost first
        for (int column = 0; column < 9; ++column)
            raster += std::to_string(100 * row + 3 * column) + (column < 8 ? " " : "\n");
    folder.write("plane.asc", raster);
    const auto model = modelOf("dem = plane.asc\n");
    ASSERT_TRUE(model);
    EXPECT_EQ(model->surface.mesh().faces(), 2u);
    EXPECT_GE(model->surface.levels(), 4);
    model->surface.forEachVertex(
        [&](std::uint32_t vertex)
        {
            const glm::dvec3& p = model->surface.point(vertex);
            EXPECT_NEAR(p.z, 10.0 * p.y + 0.3 * p.x, 1e-6) << vertex;
        });
}

} // namespace osgTerrainROAM::core
