// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/method/PrepareTerrain.h>

#include "SyntheticField.h"
#include "measurement/flights/BenchmarkFlight.h"

namespace
{

using namespace osgTerrainROAM::core;

TEST(Method, HasOneName)
{
    for (std::size_t i = 0; i < kMethods.size(); ++i)
    {
        EXPECT_EQ(static_cast<std::size_t>(kMethods[i].method), i)
            << "the table is not in the enumeration's order";
        EXPECT_EQ(methodNamed(kMethods[i].name), kMethods[i].method);
    }
    EXPECT_EQ(methodsByName().size(), kMethods.size());
    EXPECT_FALSE(methodNamed("magic"));
    EXPECT_FALSE(methodNamed(""));
}

TEST(Method, RefusesWhatItCannotDoByItsName)
{
    for (const MethodTraits& traits : kMethods)
    {
        const auto accepts = [&](const MethodRequest& request)
        {
            const auto checked = checkMethod(request, "RoamDrawable");
            if (!checked)
            {
                EXPECT_EQ(checked.error().place, "RoamDrawable.method");
                EXPECT_NE(checked.error().what.find(traits.name), std::string::npos);
                EXPECT_FALSE(checked.error().remedy.empty());
            }
            return static_cast<bool>(checked);
        };
        EXPECT_TRUE(accepts({.method = traits.method}));
        EXPECT_EQ(accepts({.method = traits.method, .patchExponent = 4}), traits.hasPatches);
        EXPECT_EQ(accepts({.method = traits.method, .morphing = true}), traits.morphs);
        EXPECT_EQ(accepts({.method = traits.method, .limitsTime = true}), traits.stopsInTime);
        EXPECT_EQ(accepts({.method = traits.method, .inSight = true}), traits.refinesInSight);
    }
}

/// The corners of all triangles in the grid, in an order of their own.
std::vector<std::array<int, 6>> trianglesOf(const DrawnMesh& drawn)
{
    std::vector<std::array<int, 6>> triangles;
    for (const LeafTriangle& t : drawn.triangles)
    {
        std::array<std::array<int, 2>, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = {drawn.grid[t.vertices[i]].column, drawn.grid[t.vertices[i]].row};
        std::ranges::sort(corners);
        triangles.push_back(
            {corners[0][0], corners[0][1], corners[1][0], corners[1][1], corners[2][0], corners[2][1]});
    }
    std::ranges::sort(triangles);
    return triangles;
}

TEST(Method, RoamIsTheSameSetOfTrianglesByThePapersLoopByTheQueuesAndByTheWheelAtRest)
{
    const auto tile = testsupport::planarTile(testsupport::hills(65, 65));
    std::vector<std::unique_ptr<TerrainMesh>> meshes;
    for (const Method method : {Method::roam, Method::roamWalk, Method::roamQueue})
        meshes.push_back((*prepareTerrain(tile, {.method = method}))->newMesh());
    std::vector<std::array<int, 6>> before;
    for (const auto path : {measurement::Path::flight, measurement::Path::jump})
        for (int frame = 0; frame < 12; ++frame)
        {
            const auto view = measurement::BenchmarkFlight::along(path).view(tile->tile, frame / 2 * 8);
            const bool isAtRest = frame % 2 == 1; // the eye stays for a frame
            for (const auto& mesh : meshes)
                mesh->refine(view, {.errorTolerancePx = 2.0});
            const auto triangles = trianglesOf(meshes[0]->drawn());
            EXPECT_EQ(trianglesOf(meshes[1]->drawn()), triangles) << "the paper's loop, frame " << frame;
            EXPECT_EQ(trianglesOf(meshes[2]->drawn()), triangles) << "the queues, frame " << frame;
            EXPECT_EQ(triangles == before, isAtRest) << "frame " << frame;
            before = triangles;
        }
    EXPECT_GT(before.size(), 300u);
}

TEST(Method, EveryOneDrawsATile)
{
    const auto tile = testsupport::planarTile(testsupport::hills(40, 35));
    for (const MethodTraits& traits : kMethods)
    {
        const auto prepared = prepareTerrain(tile, {.method = traits.method});
        ASSERT_TRUE(prepared) << traits.name;
        const std::unique_ptr<TerrainMesh> mesh = (*prepared)->newMesh();
        EXPECT_EQ(&mesh->tile(), tile.get());
        const RefineResult coarse = mesh->refine(1e9);
        EXPECT_LE(coarse.leaves, (*prepared)->fewestTriangles()) << traits.name;
        const RefineResult fine = mesh->refine(5.0);
        EXPECT_GT(fine.triangles, coarse.triangles) << traits.name;
        EXPECT_EQ(fine.triangles, mesh->drawn().triangles.size()) << traits.name;
        EXPECT_TRUE(mesh->isValid()) << traits.name;
    }
}

} // namespace
