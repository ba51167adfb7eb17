// SPDX-License-Identifier: Apache-2.0
#include "view/Channel.h"

#include <cmath>

#include <foundation/Angle.h>
#include <gtest/gtest.h>

#include <viewlod/ViewState.h>

using scenery::Pose;
using trainer::Channel;

namespace
{

Channel offAxisChannel()
{
    Channel channel;
    channel.name = "c";
    channel.widthPx = 800;
    channel.heightPx = 600;
    channel.frustum = {-20.0, 35.0, -15.0, 25.0};
    return channel;
}

/// Where a direction relative to an eye at the origin looking along x comes to lie in the picture, −1 to 1.
glm::dvec2 projected(const Channel& channel, const Pose& eye, const glm::dvec3& pointWorld)
{
    const glm::dmat4 clip = trainer::channelProjection(channel, 1.0, 1000.0) *
                            scenery::viewFromWorld(trainer::channelEye(channel, eye));
    const glm::dvec4 point = clip * glm::dvec4(pointWorld, 1.0);
    return glm::dvec2(point) / point.w;
}

glm::dvec3 direction(double rightDeg, double upDeg)
{
    return {10.0, -10.0 * std::tan(foundation::radiansOf(rightDeg)),
            10.0 * std::tan(foundation::radiansOf(upDeg))};
}

} // namespace

TEST(Channel, FrustumEdgesComeToLieOnThePicturesEdges)
{
    const Channel channel = offAxisChannel();
    const glm::dvec2 lower = projected(channel, {}, direction(-20.0, -15.0));
    EXPECT_NEAR(lower.x, -1.0, 1e-12);
    EXPECT_NEAR(lower.y, -1.0, 1e-12);
    const glm::dvec2 upper = projected(channel, {}, direction(35.0, 25.0));
    EXPECT_NEAR(upper.x, 1.0, 1e-12);
    EXPECT_NEAR(upper.y, 1.0, 1e-12);
}

TEST(Channel, YawLooksRightPitchLooksUpRollLowersTheRightSide)
{
    Channel channel = offAxisChannel();
    channel.frustum = trainer::symmetricFrustumX(60.0, 800, 600);
    channel.yawDeg = 30.0;
    EXPECT_NEAR(projected(channel, {}, direction(30.0, 0.0)).x, 0.0, 1e-12);
    channel.yawDeg = 0.0;
    channel.pitchDeg = 20.0;
    EXPECT_NEAR(projected(channel, {}, direction(0.0, 20.0)).y, 0.0, 1e-12);
    channel.pitchDeg = 0.0;
    channel.rollDeg = 10.0;
    EXPECT_GT(projected(channel, {}, direction(20.0, 0.0)).y, 0.0) << "the world turns the other way";
}

TEST(Channel, PositionIsInTheEyesFrame)
{
    Channel channel = offAxisChannel();
    channel.positionM = {1.0, 2.0, 3.0};
    Pose eye;
    eye.positionWorld = {100.0, 200.0, 300.0};
    eye.worldFromBody = glm::dmat3(0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0); // looks north
    EXPECT_EQ(trainer::channelEye(channel, eye).positionWorld, glm::dvec3(98.0, 201.0, 303.0));
}

TEST(Channel, LevelOfDetailSeesTheSameEyeNearPlaneAndPixelScale)
{
    const Channel channel = offAxisChannel();
    Pose eye;
    eye.positionWorld = {1000.0, -2000.0, 50.0};
    const auto state = viewlod::ViewState::fromMatrices(
        scenery::viewFromWorld(eye), trainer::channelProjection(channel, 0.5, 9e4), 800, 600);
    EXPECT_NEAR(glm::distance(state.eyeWorld, eye.positionWorld), 0.0, 1e-9);
    EXPECT_NEAR(state.nearM, 0.5, 1e-9);
    EXPECT_NEAR(state.cornerStretch,
                1.0 + std::pow(std::tan(foundation::radiansOf(35.0)), 2.0) +
                    std::pow(std::tan(foundation::radiansOf(25.0)), 2.0),
                1e-9);
}

TEST(Channel, SymmetricFrustaHaveSquarePixels)
{
    const trainer::FrustumAngles byWidth = trainer::symmetricFrustumX(60.0, 960, 540);
    const trainer::FrustumAngles byHeight = trainer::symmetricFrustumY(2.0 * byWidth.topDeg, 960, 540);
    EXPECT_NEAR(byHeight.rightDeg, 30.0, 1e-9);
}

TEST(Channel, AZoomedPictureShowsTheMiddleSoManyTimesAsLarge)
{
    const double deg = trainer::zoomedDeg(trainer::kPictureDeg, 4.0);
    const glm::dmat4 whole =
                         trainer::channelProjection(trainer::singleChannel(320, 160).channels[0], 1.0, 9.0),
                     part = trainer::channelProjection(trainer::singleChannel(320, 160, deg).channels[0], 1.0,
                                                       9.0);
    EXPECT_NEAR(part[0][0], 4.0 * whole[0][0], 1e-9);
    EXPECT_NEAR(part[1][1], 4.0 * whole[1][1], 1e-9);
    EXPECT_EQ(trainer::zoomedDeg(55.0, 1.0), 55.0);
}

TEST(Channel, TiledChannelsMakeOnePicture)
{
    trainer::ViewSetup setup = trainer::singleChannel(640, 480);
    setup.channels.push_back(offAxisChannel());
    ASSERT_EQ(trainer::picturesOf(setup).size(), 2U);
    EXPECT_EQ(trainer::picturesOf(setup)[1].widthPx, 800);
    setup.layout = trainer::ViewSetup::Layout::tiled;
    const auto pictures = trainer::picturesOf(setup);
    ASSERT_EQ(pictures.size(), 1U);
    EXPECT_EQ(pictures[0].widthPx, 1440);
    EXPECT_EQ(pictures[0].heightPx, 600);
}
