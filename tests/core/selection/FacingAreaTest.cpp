// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/selection/FacingArea.h>

#include "ClosedMeshes.h"
#include "SelectionScenes.h"
#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;

/// r = a (n · v) / d² of each face, in pixels.
double byFaces(const SelectionView& view, const BoundingSphere& sphere, const Mesh& mesh)
{
    const glm::dvec3 toEye = view.eyeWorld - sphere.centre;
    double sum = 0.0;
    for (const Face& face : mesh.faces)
    {
        const glm::dvec3 area =
            0.5 * glm::cross(mesh.at(face, 1) - mesh.at(face, 0), mesh.at(face, 2) - mesh.at(face, 0));
        sum += std::max(0.0, glm::dot(area, glm::normalize(toEye)));
    }
    return view.pixelsPerTangentArea * sum / glm::dot(toEye, toEye);
}

TEST(FacingArea, OfACubesSidesIsTheSumOverItsFaces)
{
    const Mesh cube = testsupport::griddedCube(3);
    const FacingBins bins = facingBinsOf(cube);
    const BoundingSphere sphere{glm::dvec3(1.5), 2.6};
    Random random(6);
    for (int i = 0; i < 200; ++i)
    {
        const auto view = SelectionView::from(
            testsupport::viewTo(sphere.centre + 30.0 * testsupport::direction(random), sphere.centre));
        const double exact = byFaces(view, sphere, cube);
        EXPECT_NEAR(facingAreaPx(view, sphere, bins, glm::dmat3(1), 1.0) / exact, 1.0, 1e-6);
    }
}

TEST(FacingArea, OfABallIsTheSumOverItsFacesWithinATenthAndNeverMore)
{
    const Mesh ball = testsupport::ball(30, 60);
    const FacingBins bins = facingBinsOf(ball);
    Random random(7);
    for (int i = 0; i < 200; ++i)
    {
        const auto view =
            SelectionView::from(testsupport::viewTo(25.0 * testsupport::direction(random), glm::dvec3(0)));
        const double ratio =
            facingAreaPx(view, {{}, 1.0}, bins, glm::dmat3(1), 1.0) / byFaces(view, {{}, 1.0}, ball);
        EXPECT_LT(ratio, 1.0 + 1e-6);
        EXPECT_GT(ratio, 0.9);
    }
}

TEST(FacingArea, OfASignVanishesAtItsEdgeAndBehindWhereABoxStays)
{
    const Mesh sign = testsupport::grid(4, 4); // in the plane z = 0, seen from above
    const FacingBins bins = facingBinsOf(sign);
    const auto at = [&](const glm::dvec3& eye)
    {
        return facingAreaPx(SelectionView::from(testsupport::viewTo(eye, glm::dvec3(0))), {{}, 3.0}, bins,
                            glm::dmat3(1), 1.0);
    };
    EXPECT_GT(at({0, 0, 20}), 100.0);
    EXPECT_NEAR(at({20, 0, 0}), 0.0, 1e-3);
    EXPECT_EQ(at({0, 0, -20}), 0.0);
    EXPECT_NEAR(at({0, 12, 16}) / at({0, 0, 20}), 0.8, 1e-6); // n · v
    EXPECT_NEAR(at({0, 0, 40}) / at({0, 0, 20}), 0.25, 1e-6); // d²
    EXPECT_EQ(at({0, 0, 2}), kFullArea);
}

TEST(FacingArea, TurnsAndGrowsWithItsObject)
{
    Random random(8);
    const Mesh cube = testsupport::griddedCube(2);
    const glm::dmat3 turn = testsupport::rotation(random), axes = testsupport::rotation(random);
    Mesh turned = cube;
    for (glm::dvec3& p : turned.positions)
        p = turn * (p - 1.0) * 2.5;
    const auto view = SelectionView::from(testsupport::viewTo({30, 20, 10}, glm::dvec3(0)));
    EXPECT_NEAR(facingAreaPx(view, {{}, 4.4}, facingBinsOf(cube), turn, 2.5) /
                    byFaces(view, {{}, 4.4}, turned),
                1.0, 1e-5);
    // Bins about other axes: the cube's sides then fall between them, but no more is seen than before.
    const double other = facingAreaPx(view, {{}, 4.4}, facingBinsOf(cube, axes), turn * axes, 2.5);
    EXPECT_NEAR(other / byFaces(view, {{}, 4.4}, turned), 1.0, 1e-5);
    EXPECT_GT(std::abs(facingAreaPx(view, {{}, 4.4}, facingBinsOf(cube), axes, 2.5) / other - 1.0), 1e-3);
}

} // namespace
