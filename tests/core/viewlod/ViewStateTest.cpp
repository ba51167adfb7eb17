// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <viewlod/ScreenError.h>
#include <viewlod/ViewState.h>

namespace
{

using viewlod::ViewState;

ViewState sixtyDegrees()
{
    const double aspect = 1280.0 / 1024.0, fovY = 2.0 * std::atan(std::tan(glm::radians(30.0)) / aspect);
    return ViewState::fromMatrices(
        glm::lookAt(glm::dvec3(1e5, 2e5, 300), glm::dvec3(1e5, 3e5, 300), glm::dvec3(0, 0, 1)),
        glm::perspective(fovY, aspect, 2.0, 1e5), 1280, 1024);
}

TEST(ViewState, ComesFromMatricesAsTheyAre)
{
    const ViewState view = sixtyDegrees();
    EXPECT_NEAR(glm::distance(view.eyeWorld, glm::dvec3(1e5, 2e5, 300)), 0.0, 1e-6);
    EXPECT_NEAR(view.pixelsPerTangent, 1280.0 / (2.0 * std::tan(glm::radians(30.0))), 1e-9);
    EXPECT_NEAR(view.nearM, 2.0, 1e-9);
}

TEST(ViewState, CornersStretchPixelsAsTheSpecificationSays)
{
    EXPECT_NEAR(sixtyDegrees().cornerStretch, 1.55, 0.005); // 1/cos² at the corners of 1280×1024, 60° wide
}

TEST(ViewState, OffAxisFrustumHasItsFarCornerCounted)
{
    const ViewState view =
        ViewState::fromMatrices(glm::dmat4(1.0), glm::frustum(-1.0, 3.0, -1.0, 1.0, 1.0, 100.0), 400, 200);
    EXPECT_NEAR(view.cornerStretch, 1.0 + 9.0 + 1.0, 1e-12);
    EXPECT_NEAR(view.pixelsPerTangent, 100.0, 1e-12);
}

TEST(ScreenError, BoundGrowsUntilTheNearDistance)
{
    EXPECT_DOUBLE_EQ(viewlod::screenErrorBoundPx(1000, 2, 500, 100, 1), 5.0);
    EXPECT_DOUBLE_EQ(viewlod::screenErrorBoundPx(1000, 2, 50, 100, 4), 500.0);
}

TEST(ScreenError, ProjectionPutsTheAimInTheMiddleAndHidesWhatIsBehind)
{
    const ViewState view = sixtyDegrees();
    const auto middle = viewlod::projectPx(view, {1e5, 2.5e5, 300});
    ASSERT_TRUE(middle);
    EXPECT_NEAR(middle->x, 640, 1e-6);
    EXPECT_NEAR(middle->y, 512, 1e-6);
    EXPECT_FALSE(viewlod::projectPx(view, {1e5, 1.9e5, 300}));
}

} // namespace
