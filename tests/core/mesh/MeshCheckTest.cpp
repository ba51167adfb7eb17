// SPDX-License-Identifier: Apache-2.0
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/MeshCheck.h>

#include "MadeMeshes.h"

namespace
{

using namespace osgPMObjects::core;

TEST(MeshCheck, AcceptsWholeMeshesAndTheEmptyOne)
{
    EXPECT_EQ(defectOf(testsupport::cube()), "");
    EXPECT_EQ(defectOf(testsupport::grid(5, 3)), "");
    EXPECT_EQ(defectOf(Mesh{}), "");
    Mesh mesh = testsupport::cube();
    mesh.normals.assign(8, {0.0f, 0.0f, 1.0f});
    mesh.colours.assign(8, {1.0f, 1.0f, 1.0f, 1.0f});
    mesh.texCoords[1].assign(8, {});
    EXPECT_TRUE(isValid(mesh));
}

TEST(MeshCheck, SeesEveryMutation)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const float infinite = std::numeric_limits<float>::infinity();
    const std::pair<const char*, std::function<void(Mesh&)>> mutations[] = {
        {"positions[3]", [&](Mesh& m) { m.positions[3].y = nan; }},
        {"wedge 2", [](Mesh& m) { m.wedgePositions[2] = 8; }},
        {"normals has 7", [](Mesh& m) { m.normals.resize(7); }},
        {"normals[1]", [&](Mesh& m) { m.normals.assign(8, {}), m.normals[1].x = infinite; }},
        {"texCoords[0] has 9", [](Mesh& m) { m.texCoords[0].resize(9); }},
        {"texCoords[1][7]", [&](Mesh& m) { m.texCoords[1].assign(8, {}), m.texCoords[1][7].y = infinite; }},
        {"colours has 1", [](Mesh& m) { m.colours.resize(1); }},
        {"colours[0]", [&](Mesh& m) { m.colours.assign(8, {}), m.colours[0].a = infinite; }},
        {"faces[11] names wedge 8", [](Mesh& m) { m.faces[11].wedges[2] = 8; }},
        {"faces[0] names material 1", [](Mesh& m) { m.faces[0].material = 1; }},
        {"faces[5] names part 9", [](Mesh& m) { m.faces[5].part = 9; }},
    };
    for (const auto& [place, mutate] : mutations)
    {
        Mesh mesh = testsupport::cube();
        mutate(mesh);
        EXPECT_TRUE(defectOf(mesh).starts_with(place)) << place << " against " << defectOf(mesh);
    }
}

} // namespace
