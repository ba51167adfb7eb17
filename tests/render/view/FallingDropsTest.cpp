// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/FallingDrops.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "RenderedView.h"

namespace
{

/// Looks down at an even ground from `eye`, while it rains.
osg::ref_ptr<osg::Image> groundWith(const simulation::Hydrometeors& falling, double timeS,
                                    const glm::dvec3& eye, const osg::Vec3d& eyeVelocity = {})
{
    osgSky::AtmosphereSettings air;
    air.cloudCover = 1.0;
    const rendered::ViewScene scene(air);
    scenery::FallingDrops drops;
    drops.show(falling, timeS, {}, eyeVelocity);
    scene.root->addChild(&drops.node());
    return rendered::pictureFrom(scene.root, scenery::poseLookingAt(eye, eye + glm::dvec3(0.0, 1.0, -1.5)),
                                 rendered::smallPicture());
}

/// The number of pixels that differ by more than a level.
int differing(const osg::Image& a, const osg::Image& b)
{
    int count = 0;
    for (int y = 0; y < a.t(); ++y)
        for (int x = 0; x < a.s(); ++x)
        {
            const unsigned char* one = a.data(static_cast<unsigned>(x), static_cast<unsigned>(y));
            const unsigned char* other = b.data(static_cast<unsigned>(x), static_cast<unsigned>(y));
            bool differs = false;
            for (int channel = 0; channel < 3; ++channel)
                differs = differs || std::abs(one[channel] - other[channel]) > 1;
            count += differs;
        }
    return count;
}

const glm::dvec3 kUnderRain(3.0, 4.0, 50.0);

} // namespace

TEST(FallingDrops, RainAndSnowAreSeenAndTheMoreTheHeavier)
{
    const auto dry = groundWith({}, 1.0, kUnderRain);
    const int light = differing(*dry, *groundWith(simulation::rainOf(1.0), 1.0, kUnderRain));
    const int heavy = differing(*dry, *groundWith(simulation::rainOf(20.0), 1.0, kUnderRain));
    EXPECT_GT(light, 20);
    EXPECT_GT(heavy, 3 * light);
    EXPECT_GT(differing(*dry, *groundWith(simulation::snowOf(2.0), 1.0, kUnderRain)), 100);
}

TEST(FallingDrops, FallAtTheirSpeed)
{
    // A drop that has fallen by the height of the box is where another was: the picture is the same, and at
    // half of that time it is not.
    const simulation::Hydrometeors rain = simulation::rainOf(10.0);
    const double wholeS = scenery::FallingDrops::kBoxM / rain.fallMps;
    const auto now = groundWith(rain, 0.0, kUnderRain);
    EXPECT_LT(differing(*now, *groundWith(rain, wholeS, kUnderRain)), 20);
    EXPECT_GT(differing(*now, *groundWith(rain, 0.5 * wholeS, kUnderRain)), 500);
}

TEST(FallingDrops, StandInTheWorldWhereverThatIs)
{
    // The ground is the same everywhere, so drops alone tell where the eye is.
    const simulation::Hydrometeors rain = simulation::rainOf(10.0);
    const auto here = groundWith(rain, 2.0, kUnderRain);
    const double wholeM = 1000.0 * scenery::FallingDrops::kBoxM;
    EXPECT_LT(differing(*here, *groundWith(rain, 2.0, kUnderRain + glm::dvec3(wholeM, -4.0 * wholeM, 0.0))),
              20);
    EXPECT_GT(differing(*here, *groundWith(rain, 2.0, kUnderRain + glm::dvec3(wholeM + 2.0, 0.0, 0.0))), 500);
}

TEST(FallingDrops, AreLongerStreaksForAnEyeThatMoves)
{
    const simulation::Hydrometeors rain = simulation::rainOf(10.0);
    const auto dry = groundWith({}, 1.0, kUnderRain);
    const int standing = differing(*dry, *groundWith(rain, 1.0, kUnderRain));
    const int driving = differing(*dry, *groundWith(rain, 1.0, kUnderRain, {0.0, 30.0, 0.0}));
    EXPECT_GT(driving, standing * 5 / 4);
}
