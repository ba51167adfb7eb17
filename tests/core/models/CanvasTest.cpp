// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/paint/Canvas.h"

#include <array>

#include <gtest/gtest.h>

using scenery::models::Canvas;

TEST(Canvas, CoversPixelsByTheirShare)
{
    Canvas canvas(4, 4, glm::vec4(0.0F));
    canvas.rectangle({1.0F, 1.0F}, {2.5F, 2.0F}, glm::vec4(1.0F));
    EXPECT_FLOAT_EQ(canvas.pixel(1, 1).r, 1.0F);
    EXPECT_FLOAT_EQ(canvas.pixel(2, 1).r, 0.5F);
    EXPECT_FLOAT_EQ(canvas.pixel(3, 1).r, 0.0F);
    EXPECT_FLOAT_EQ(canvas.pixel(1, 2).r, 0.0F);
}

TEST(Canvas, AHalfCoveredEdgeKeepsTheLeafsColour)
{
    Canvas canvas(2, 1, glm::vec4(0.2F, 0.4F, 0.1F, 0.0F));
    canvas.rectangle({0.0F, 0.0F}, {0.5F, 1.0F}, glm::vec4(0.2F, 0.4F, 0.1F, 1.0F));
    EXPECT_FLOAT_EQ(canvas.pixel(0, 0).g, 0.4F);
    EXPECT_FLOAT_EQ(canvas.pixel(0, 0).a, 0.5F);
}

TEST(Canvas, PaintsInMetresAndOutsideIsLeftAlone)
{
    Canvas canvas(8, 8, glm::vec4(0.0F));
    canvas.setFrame({4.0F, 4.0F}, {2.0F, 2.0F});
    canvas.rectangle({-1.0F, -1.0F}, {9.0F, 0.0F}, glm::vec4(1.0F));
    EXPECT_FLOAT_EQ(canvas.pixel(2, 2).r, 1.0F);
    EXPECT_FLOAT_EQ(canvas.pixel(7, 3).r, 1.0F);
    EXPECT_FLOAT_EQ(canvas.pixel(1, 2).r, 0.0F);
    EXPECT_FLOAT_EQ(canvas.pixel(2, 4).r, 0.0F);
}

TEST(Canvas, ADiscHasItsArea)
{
    Canvas canvas(64, 64, glm::vec4(0.0F));
    canvas.disc({32.0F, 32.0F}, 20.0F, glm::vec4(1.0F));
    float sum = 0.0F;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            sum += canvas.pixel(x, y).a;
    EXPECT_NEAR(sum, 3.14159F * 400.0F, 12.0F);
}
