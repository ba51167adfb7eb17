// SPDX-License-Identifier: Apache-2.0
#include <collapse/AreaCost.h>
#include <gtest/gtest.h>
#include <quadric/KeepArea.h>

#include "MadeMeshes.h"
#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;

/// A square of two triangles: 0 (0,0), 1 (2,0), 2 (2,2), 3 (0,2), with the diagonal 0-2.
struct Square
{
    Mesh mesh = testsupport::meshOf({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
                                    std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}});
    StarMesh stars{mesh};
    Star from, to;

    explicit Square(std::uint32_t a, std::uint32_t b)
    {
        from.gather(stars, mesh.positions, a);
        to.gather(stars, mesh.positions, b);
    }
    MergingStars merging() const { return {from, to, mesh.positions}; }
};

TEST(KeepArea, GivesTheLastTriangleTheAreaOfTwo)
{
    const Square square(1, 2); // leaves the triangle 0, x, 3
    const glm::dvec3 at = placeKeepingArea(square.merging(), {2.0, 1.0, 0.0}, 10.0);
    EXPECT_NEAR(0.5 * glm::length(glm::cross(at, glm::dvec3(0, 2, 0))), 4.0, 1e-3);
    EXPECT_NEAR(at.x, 4.0, 1e-3);
    EXPECT_EQ(at.y, 1.0); // away from the middle of 0 and 3
}

TEST(KeepArea, GoesNoFartherThanAllowed)
{
    const Square square(1, 2);
    EXPECT_NEAR(placeKeepingArea(square.merging(), {2.0, 1.0, 0.0}, 0.5).x, 2.5, 1e-9);
    EXPECT_EQ(placeKeepingArea(square.merging(), {5.0, 1.0, 0.0}, 0.5),
              glm::dvec3(5.0, 1.0, 0.0)); // no less area
}

TEST(AreaCost, TellsTheEndOfATubeFromAPlane)
{
    const Square square(1, 2);
    EXPECT_NEAR(thinnessOf(square.to), 0.0, 1e-12);
    const Mesh cube = testsupport::cube();
    const StarMesh stars(cube);
    Star corner;
    corner.gather(stars, cube.positions, 0);
    EXPECT_GT(thinnessOf(corner), 0.3);
    const AreaCost subset = AreaCost::forModel({.placement = Placement::subset}, 1.0);
    EXPECT_GT(subset.of(corner, 0.1), 1e3 * subset.of(square.to, 0.1));
    EXPECT_EQ(AreaCost::forModel({.placement = Placement::subset}, 1.0, true).of(corner, 0.1), 0.0); // twigs
}

TEST(AreaCost, CountsMoreInScatteredModels)
{
    const Square square(1, 2);
    const auto cost = [&](double size)
    { return AreaCost::forModel({.placement = Placement::optimal}, size).of(square.to, 0.1); };
    EXPECT_EQ(cost(1.0), cost(0.2));
    EXPECT_NEAR(cost(0.02) / cost(0.2), 1e4, 1.0);
    EXPECT_EQ(AreaCost::forModel({.joinDistance = 0.1}, 1.0).mostSwelling, 0.0);
}

} // namespace
