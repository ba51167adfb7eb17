// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/bake/AtlasCheck.h>
#include <osgPMObjects/core/bake/AtlasMesh.h>
#include <osgPMObjects/core/bake/PackCharts.h>
#include <osgPMObjects/core/mesh/MeshCheck.h>

#include "MadeMeshes.h"
#include "RoundMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::cube;

Atlas atlasOf(const Mesh& mesh, const PackSettings& settings)
{
    auto atlas = packCharts(mesh, makeCharts(mesh), settings);
    EXPECT_TRUE(atlas) << atlas.error().message();
    return atlas ? *atlas : Atlas();
}

Mesh bumps()
{
    return testsupport::roundMesh(48, 24, testsupport::onBumps);
}

TEST(PackCharts, LeavesGuttersAndNoTexelToTwoFaces)
{
    for (const Mesh& mesh : {cube(), bumps()})
        for (const PackSettings& settings :
             {PackSettings{128, 1}, PackSettings{256, 2}, PackSettings{512, 5}})
        {
            const Atlas atlas = atlasOf(mesh, settings);
            EXPECT_EQ(defectOf(mesh, atlas, settings.gutterPx), "");
        }
}

TEST(PackCharts, OfACubeFillMostOfTheAtlas)
{
    // Six squares in a grid of three by two leave a third free; only unequal rows are better.
    const Atlas atlas = atlasOf(cube(), {256, 1});
    EXPECT_GE(6.0 * atlas.texelsPerUnit * atlas.texelsPerUnit, 0.6 * 256 * 256);
}

TEST(PackCharts, ScaleTheSameWhereverTheMeshLies)
{
    Mesh far = cube();
    for (glm::dvec3& p : far.positions)
        p += glm::dvec3(4e5, 5e6, 100.0);
    EXPECT_EQ(defectOf(far, atlasOf(far, {256, 2}), 2), "");
    EXPECT_NEAR(atlasOf(far, {256, 2}).texelsPerUnit, atlasOf(cube(), {256, 2}).texelsPerUnit, 0.5);
}

TEST(PackCharts, RefuseWhatCannotBe)
{
    const Mesh mesh = cube();
    for (const PackSettings& settings :
         {PackSettings{100, 2}, PackSettings{8, 2}, PackSettings{16384, 2}, PackSettings{256, 0}})
        EXPECT_FALSE(packCharts(mesh, makeCharts(mesh), settings));
    EXPECT_FALSE(packCharts(Mesh(), Charts(), {}));
    const auto tooMany = packCharts(mesh, makeCharts(mesh), {16, 4}); // a gutter alone takes half of it
    ASSERT_FALSE(tooMany);
    EXPECT_NE(tooMany.error().message().find("6 charts do not fit"), std::string::npos)
        << tooMany.error().message();
}

TEST(PackCharts, FacesWithoutAreaDoNoHarm)
{
    Mesh mesh = cube();
    mesh.faces.push_back({{0, 0, 1}, 0, 0});
    mesh.faces.push_back({{3, 3, 3}, 0, 0});
    EXPECT_EQ(defectOf(mesh, atlasOf(mesh, {128, 2}), 2), "");
}

TEST(PackChartsMutation, AChartMovedOrGrownIsSeen)
{
    const Mesh mesh = bumps();
    const Atlas atlas = atlasOf(mesh, {256, 2});
    Atlas moved = atlas, outside = atlas, grown = atlas;
    moved.origin[0] += glm::dvec2(20.0, 0.0);
    outside.origin[1] -= glm::dvec2(1000.0, 0.0);
    grown.texelsPerUnit *= 1.5;
    EXPECT_NE(defectOf(mesh, moved, 2), "");
    EXPECT_NE(defectOf(mesh, outside, 2).find("outside"), std::string::npos);
    EXPECT_NE(defectOf(mesh, grown, 2), "");
    EXPECT_NE(defectOf(mesh, atlas, 8), "") << "a wider gutter than was asked for";
}

TEST(PackChartsMutation, FacesOverEachOtherAreSeen)
{
    const Mesh mesh = cube();
    Charts one;
    one.charts.push_back({{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {}});
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
        one.charts[0].faces.push_back(f);
    one.chartOfFace.assign(mesh.faces.size(), 0);
    // The lower side is clockwise from above; two upper ones overlap when it is duplicated.
    Mesh twice = mesh;
    twice.faces.push_back(mesh.faces[2]);
    one.charts[0].faces.push_back(12);
    one.chartOfFace.push_back(0);
    const auto atlas = packCharts(twice, one, {128, 2});
    ASSERT_TRUE(atlas);
    EXPECT_NE(defectOf(twice, *atlas, 2).find("lies over"), std::string::npos);
}

TEST(AtlasMesh, HasTheAtlasForTextureCoordinates)
{
    const Mesh mesh = bumps();
    const Atlas atlas = atlasOf(mesh, {256, 2});
    const Mesh textured = atlasMesh(mesh, atlas);
    ASSERT_EQ(defectOf(textured), "");
    ASSERT_EQ(textured.faces.size(), mesh.faces.size());
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
        for (int corner = 0; corner < 3; ++corner)
        {
            const std::uint32_t before = mesh.faces[f].wedges[static_cast<std::size_t>(corner)];
            const std::uint32_t after = textured.faces[f].wedges[static_cast<std::size_t>(corner)];
            EXPECT_EQ(textured.wedgePositions[after], mesh.wedgePositions[before]);
            EXPECT_EQ(textured.normals[after], mesh.normals[before]);
            const glm::dvec2 texel = atlas.texelOf(f, mesh.at(mesh.faces[f], corner));
            EXPECT_LT(glm::length(256.0 * glm::dvec2(textured.texCoords[0][after]) - texel), 1e-4);
        }
    // Split at borders of charts only: far fewer than three for a face.
    EXPECT_LT(textured.wedgeCount(), mesh.faces.size());
}

} // namespace
