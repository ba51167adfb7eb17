// SPDX-License-Identifier: Apache-2.0
#include "view/RoadsideCamera.h"

#include <gtest/gtest.h>

namespace
{

scenery::Pose walkedTo(double x)
{
    return {{x, 0.0, 5.0}, glm::dmat3(1.0)};
}

std::optional<simulation::GroundSample> flatGround(double, double, double)
{
    simulation::GroundSample sample;
    sample.heightM = 4.0;
    return sample;
}

} // namespace

TEST(RoadsideCamera, StandsStillAndTurnsAfterTheBody)
{
    trainer::RoadsideCamera camera(trainer::RoadsideSettings::kerb());
    const scenery::Pose first = camera.update(walkedTo(0.0), flatGround);
    EXPECT_NEAR(first.positionWorld.x, 25.0, 1e-9);
    EXPECT_NEAR(first.positionWorld.y, -7.0, 1e-9); // on the right
    EXPECT_NEAR(first.positionWorld.z, 5.7, 1e-9);
    const scenery::Pose later = camera.update(walkedTo(60.0), flatGround);
    EXPECT_EQ(later.positionWorld, first.positionWorld);
    EXPECT_LT(first.forward().x, -0.9);
    EXPECT_GT(later.forward().x, 0.9);
}

TEST(RoadsideCamera, IsPlacedAnewWhenTheBodyIsTooFarAway)
{
    trainer::RoadsideCamera camera(trainer::RoadsideSettings::kerb());
    camera.update(walkedTo(0.0), flatGround);
    EXPECT_NEAR(camera.update(walkedTo(75.0), flatGround).positionWorld.x, 100.0, 1e-9);
}

TEST(RoadsideCamera, NeedsNoGround)
{
    trainer::RoadsideCamera camera(trainer::RoadsideSettings::tower());
    EXPECT_NEAR(camera.update(walkedTo(0.0), {}).positionWorld.z, 19.0, 1e-9);
}
