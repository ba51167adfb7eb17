// SPDX-License-Identifier: Apache-2.0
// The default drive lies on the default course, which the build makes.
#include <cmath>

#include <gtest/gtest.h>

#include <osgRoads/core/query/GeoReference.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadLocator.h>
#include <osgRoads/core/read/ReadNetwork.h>

#include "simulation/parser/ParseScenario.h"

namespace
{

constexpr const char* kCourse = OSGTRAINER_DEFAULT_COURSE;
constexpr const char* kDrive = OSGTRAINER_SOURCE_DIR "/data/scenarios/drive.xosc";
constexpr int kLane = -1; ///< the right one

const simulation::Polyline* pathOf(const simulation::Scenario& scenario)
{
    for (const auto& ofOne : scenario.storyboard.init.privates)
        for (const auto& action : ofOne.actions)
            if (const auto* follow = std::get_if<simulation::FollowTrajectoryAction>(&action))
                return std::get_if<simulation::Polyline>(&follow->trajectory.shape);
    return nullptr;
}

/// The greatest distance of a vertex from the middle of the lane, metres; every vertex is moved aside by
/// `asideM` before.
double worstOff(double asideM)
{
    const auto scenario = simulation::readScenario(kDrive);
    const auto course = osgRoads::core::readNetwork(kCourse);
    EXPECT_TRUE(scenario && course);
    if (!scenario || !course) return INFINITY;
    const auto reference = osgRoads::core::GeoReference::create(course->network.header, kCourse);
    const simulation::Polyline* path = pathOf(scenario->scenario);
    EXPECT_TRUE(reference && path && path->vertices.size() == 29u);
    if (!reference || !path) return INFINITY;
    const osgRoads::core::RoadLocator locator(course->network);
    double worst = 0.0;
    for (const simulation::Vertex& vertex : path->vertices)
    {
        const auto& geo = std::get<simulation::GeoPosition>(vertex.position);
        const auto plan = reference->toInertial({geo.latitudeDeg, geo.longitudeDeg, 0.0});
        const auto on = plan ? locator.nearest(glm::dvec2(*plan)) : std::nullopt;
        EXPECT_TRUE(on);
        if (!on) return INFINITY;
        const auto& road = course->network.roads[static_cast<std::size_t>(on->position.road)];
        const auto lane = osgRoads::core::laneSpan(road, kLane, on->position.s);
        EXPECT_TRUE(lane);
        if (!lane) return INFINITY;
        worst = std::max(worst, std::fabs(on->position.t + asideM - lane->centreT()));
    }
    return worst;
}

} // namespace

TEST(DefaultDrive, KeepsToTheMiddleOfItsLane)
{
    EXPECT_LT(worstOff(0.0), 0.1);
}

TEST(DefaultDrive, OffItsLaneByTwentyCentimetresItIsNoticed) // the test above can fail
{
    EXPECT_GT(worstOff(0.2), 0.1);
}
