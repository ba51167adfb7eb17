// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/bisection/CoarseMesh.h>

#include "MadeSurfaces.h"

namespace osgTerrainROAM::core
{

namespace
{

TEST(CoarseMesh, everySideOfACubeHasATwinThatRunsTheOtherWay)
{
    const CoarseMesh cube = cubeMesh();
    EXPECT_EQ(cube.faces(), 6u);
    ASSERT_EQ(cube.sides(), 24u);
    for (std::uint32_t s = 0; s < 24; ++s)
    {
        const std::uint32_t t = cube.twin(s);
        ASSERT_NE(t, kNoSide);
        EXPECT_EQ(cube.twin(t), s);
        EXPECT_EQ(cube.origin(t), cube.origin(cube.next(s)));
        EXPECT_EQ(cube.previous(cube.next(s)), s);
        const glm::dvec3 a = cube.points()[cube.origin(s)], b = cube.points()[cube.origin(cube.next(s))],
                         c = cube.centre(cube.face(s));
        EXPECT_GT(glm::dot(glm::cross(b - a, c - a), c), 0.0) << "faces look outwards";
    }
}

TEST(CoarseMesh, sidesAtABorderOrAHoleHaveNoTwin)
{
    const BisectionSurface tin = testsupport::madeTin(1);
    std::uint32_t open = 0;
    for (std::uint32_t s = 0; s < tin.mesh().sides(); ++s)
        open += tin.mesh().twin(s) == kNoSide ? 1 : 0;
    EXPECT_EQ(open, 11u) << "eight around it, three around the hole";
}

TEST(CoarseMesh, whatIsNoMeshIsTold)
{
    const std::vector<glm::dvec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    const auto told = [&](const std::vector<std::vector<std::uint32_t>>& faces)
    {
        const auto made = CoarseMesh::make(points, faces, "here");
        return made ? std::string() : made.error().message();
    };
    EXPECT_EQ(told({{0, 1, 2}, {1, 0, 3}}), "");
    EXPECT_NE(told({{0, 1}}).find("here: face 0"), std::string::npos);
    EXPECT_NE(told({{0, 1, 2}, {0, 1, 9}}).find("face 1"), std::string::npos);
    EXPECT_NE(told({{0, 1, 1}}).find("face 0"), std::string::npos);
    EXPECT_NE(told({{0, 1, 2}, {0, 1, 3}}).find("from point 0 to point 1"), std::string::npos);
    EXPECT_NE(told({{0, 1, 2}, {1, 0, 3}, {1, 0, 4}}).find("from point 1 to point 0"), std::string::npos);
}

} // namespace

} // namespace osgTerrainROAM::core
