// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "RenderedView.h"
#include "scenery/nodes/NightSky.h"

using osgSky::AtmosphereSettings;
using osgSky::sunDirectionFromAngles;

namespace
{

AtmosphereSettings sunAt(double elevationDeg)
{
    AtmosphereSettings air;
    air.sunDirectionWorld = sunDirectionFromAngles(180.0, elevationDeg);
    return air;
}

/// Mean of the pixels of a row, per channel. Row 0 is at the bottom.
osg::Vec3f rowColour(const osg::Image& picture, int row)
{
    osg::Vec3f sum;
    for (unsigned x = 0; x < static_cast<unsigned>(picture.s()); ++x)
    {
        const unsigned char* pixel = picture.data(x, static_cast<unsigned>(row));
        sum += osg::Vec3f(pixel[0], pixel[1], pixel[2]);
    }
    return sum / static_cast<float>(picture.s());
}

/// The largest step, in levels, from one row to the next around the horizon. Rows further below show the
/// ground, which is darker than the haze.
float seamAt(const osg::Image& picture)
{
    float largest = 0.0F;
    for (int row = picture.t() / 2 - 2; row < picture.t() / 2 + 2; ++row)
    {
        const osg::Vec3f step = rowColour(picture, row + 1) - rowColour(picture, row);
        largest = std::max({largest, std::abs(step.x()), std::abs(step.y()), std::abs(step.z())});
    }
    return largest;
}

osg::ref_ptr<osg::Image> towardsHorizon(const AtmosphereSettings& air, const glm::dvec3& direction)
{
    const rendered::ViewScene scene(air);
    const glm::dvec3 eye(0.0, 0.0, 2.0);
    return rendered::pictureFrom(scene.root, scenery::poseLookingAt(eye, eye + direction),
                                 rendered::smallPicture());
}

} // namespace

TEST(Sky, HazeMeetsItWithoutASeam)
{
    for (const double elevationDeg : {50.0, 8.0, -4.0})
    {
        AtmosphereSettings air = sunAt(elevationDeg);
        air.visibilityM = 150.0; // the first row below the horizon is 670 m away: all haze
        for (const glm::dvec3& direction : {glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::dvec3(1, 0.3, 0)})
            EXPECT_LT(seamAt(*towardsHorizon(air, direction)), 1.5F)
                << "sun at " << elevationDeg << "°, looking along " << direction.x << ", " << direction.y;
    }
}

TEST(Sky, WithoutHazeTheSeamWouldBeSeen)
{
    // The mutation that the test above must catch: ground that does not take on the sky's colour.
    AtmosphereSettings air = sunAt(50.0);
    air.visibilityM = 1e7;
    EXPECT_GT(seamAt(*towardsHorizon(air, {0, 1, 0})), 6.0F);
}

TEST(Sky, GetsDarkerAsTheSunSinks)
{
    float before = 256.0F;
    for (const double elevationDeg : {45.0, 3.0, -5.0, -20.0})
    {
        const float blue = rowColour(*towardsHorizon(sunAt(elevationDeg), {0, 1, 0}), 110).z();
        EXPECT_LT(blue, before);
        before = blue;
    }
    EXPECT_LT(before, 40.0F) << "night";
}

TEST(Sky, TheSunStandsWhereItIsSaidToBe)
{
    const AtmosphereSettings air = sunAt(20.0);
    const rendered::ViewScene scene(air);
    const osg::Vec3d sun = air.sunDirectionWorld;
    const scenery::Pose eye =
        scenery::poseLookingAt({0, 0, 2}, {sun.x() * 100, sun.y() * 100, 2 + sun.z() * 100});
    const auto picture = rendered::pictureFrom(scene.root, eye, rendered::smallPicture());
    const auto level = [&](unsigned x, unsigned y)
    { return picture->data(x, y)[0] + picture->data(x, y)[1]; };
    EXPECT_GT(level(80, 60), level(60, 60));
    EXPECT_GT(level(80, 60), 500) << "its disc is bright";
}

TEST(Sky, StarsComeOutAtNightOnly)
{
    const auto brightest = [](double elevationDeg)
    {
        const rendered::ViewScene scene(sunAt(elevationDeg));
        scenery::NightSky night;
        night.show(simulation::worldFromStars(*simulation::parseDateTime("2024-12-15T22:00:00Z"), 47.0, 8.0),
                   elevationDeg, {});
        scene.root->addChild(&night.node());
        const auto picture = rendered::pictureFrom(scene.root, scenery::poseLookingAt({0, 0, 2}, {0, 1, 2.7}),
                                                   rendered::smallPicture());
        int largest = 0;
        for (unsigned y = 1; y < 120; ++y)
            for (unsigned x = 1; x < 160; ++x)
                largest = std::max(largest, picture->data(x, y)[1] - picture->data(x - 1, y)[1]);
        return largest;
    };
    EXPECT_GT(brightest(-25.0), 30);
    EXPECT_LT(brightest(30.0), 4);
}
