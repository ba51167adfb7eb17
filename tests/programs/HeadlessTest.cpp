// SPDX-License-Identifier: Apache-2.0
// `trainer play --headless` and its table: far from the origin, and with fifty entities.
#include <cmath>
#include <cstdlib>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "ProgramRun.h"
#include "Workplace.h"
#include "simulation/record/MotionTable.h"

namespace
{

using simulation::MotionTable;

/// A car that turns along a smooth trajectory, a second one that follows places relative to it, and an
/// aircraft that climbs: no roads, no terrain, everything `eastM` and `northM` from where the file would have
/// it.
std::string shifted(double eastM, double northM)
{
    const auto world = [&](double x, double y, const std::string& more = "")
    {
        return "<WorldPosition x=\"" + std::to_string(x + eastM) + "\" y=\"" + std::to_string(y + northM) +
               "\" z=\"0\" " + more + "/>";
    };
    simulation::ScenarioText text;
    text.entities += "<ScenarioObject name=\"Other\">" + simulation::kCar + "</ScenarioObject>";
    text.globals = R"(<Private entityRef="Other">)" + simulation::teleport(world(20, 40, "h=\"0.7\"")) +
                   simulation::speedAction(8.0) + "</Private>";
    text.privates =
        simulation::teleport(world(0, 0, "h=\"0.3\"")) +
        simulation::speedAction(12.0, "sinusoidal", "time", 3.0) +
        simulation::followTrajectory(simulation::vertex(world(0, 0)) + simulation::vertex(world(30, 5)) +
                                         simulation::vertex(world(60, -8)) + simulation::vertex(world(90, 4)),
                                     "<None/>", "follow");
    text.stories = simulation::story(
        simulation::event(
            "a", simulation::teleport("<RelativeObjectPosition entityRef=\"Other\" dx=\"-12\" dy=\"3\"/>"),
            simulation::timeCondition(8.0)) +
        simulation::event(
            "b",
            R"(<PrivateAction><RoutingAction><FollowTrajectoryAction><TrajectoryRef><Trajectory name="t" closed="false"><Shape>
<Clothoid curvature="0.02" curvaturePrime="0.001" length="60"><Position><RelativeObjectPosition entityRef="Ego" dx="0" dy="0"/></Position></Clothoid></Shape>
</Trajectory></TrajectoryRef><TimeReference><None/></TimeReference><TrajectoryFollowingMode followingMode="position"/></FollowTrajectoryAction></RoutingAction></PrivateAction>)",
            simulation::timeCondition(9.0)));
    text.stop = simulation::stopAt(15.0);
    return text.text();
}

MotionTable tableOf(const Workplace& place, const std::string& name, const std::string& scenario)
{
    const std::string log = place.path(name + ".csv");
    const ProgramRun run = runTrainer({"play", place.write(name + ".xosc", scenario), "--headless",
                                       "--fixed_timestep", "0.01", "--csv_logger", log});
    EXPECT_TRUE(succeeds(run)) << run.text();
    auto table = simulation::readMotionTable(log);
    EXPECT_TRUE(table) << table.error().message();
    return table ? std::move(*table) : MotionTable{};
}

/// The largest difference of the places of two tables, the second one moved back.
double farthestM(const MotionTable& here, const MotionTable& there, const glm::dvec3& shift)
{
    if (here.timeS != there.timeS || here.tracks.size() != there.tracks.size()) return 1e9;
    double farthest = 0.0;
    for (std::size_t i = 0; i < here.tracks.size(); ++i)
        for (std::size_t row = 0; row < here.timeS.size(); ++row)
        {
            const auto &a = here.tracks[i].samples[row], &b = there.tracks[i].samples[row];
            if (a.has_value() != b.has_value()) return 1e9;
            if (a) farthest = std::max(farthest, glm::length(b->position - shift - a->position));
        }
    return farthest;
}

TEST(Headless, ATenThousandKilometresAwayTheTableIsTheSameToAMillimetre)
{
    const Workplace place;
    const MotionTable here = tableOf(place, "here", shifted(0.0, 0.0));
    ASSERT_GT(here.timeS.size(), 1400u);
    EXPECT_LT(farthestM(here, tableOf(place, "there", shifted(1e7, -1e7)), {1e7, -1e7, 0.0}), 1e-3);
    EXPECT_GT(farthestM(here, tableOf(place, "beside", shifted(0.002, 0.0)), {0.0, 0.0, 0.0}), 1.9e-3)
        << "two millimetres are seen";
    EXPECT_GT(glm::length(here.tracks[0].samples.back()->position), 50.0);
}

/// Fifty cars on the roads of multi_intersections: Ego, and a swarm of 49 with car-following drivers that
/// turn by chance.
std::string fifty(const std::string& roads)
{
    simulation::ScenarioText text;
    text.globals =
        R"(<GlobalAction><TrafficAction trafficName="swarm"><TrafficSwarmAction semiMajorAxis="2000" semiMinorAxis="2000" innerRadius="0" offset="0" numberOfVehicles="49">
<CentralObject entityRef="Ego"/><TrafficDefinition name="mixed"><VehicleCategoryDistribution>
<VehicleCategoryDistributionEntry category="car" weight="6"/><VehicleCategoryDistributionEntry category="truck" weight="2"/><VehicleCategoryDistributionEntry category="bus" weight="1"/></VehicleCategoryDistribution></TrafficDefinition>
</TrafficSwarmAction></TrafficAction></GlobalAction>)";
    text.privates = simulation::teleport(R"(<RoadPosition roadId="196" s="10" t="-1.75"/>)") +
                    simulation::speedAction(8.0) +
                    "<PrivateAction><RoutingAction><RandomRouteAction/></RoutingAction></PrivateAction>";
    text.stop = simulation::stopAt(60.0);
    return with(text.text(), "<RoadNetwork/>",
                "<RoadNetwork><LogicFile filepath=\"" + roads + "\"/></RoadNetwork>");
}

TEST(Headless, FiftyVehiclesOnAJunctionNetworkArePlayedToTheEnd)
{
    const char* const folder = std::getenv("OSGTRAINER_REAL_DATA");
    if (!folder || !*folder)
        GTEST_SKIP() << "OSGTRAINER_REAL_DATA is unset: no real data, nothing was tested";
    const std::string roads = std::string(folder) + "/openscenario/esmini/xodr/multi_intersections.xodr";
    const Workplace place;
    const std::string log = place.path("fifty.csv");
    const ProgramRun run = runTrainer({"play", place.write("fifty.xosc", fifty(roads)), "--headless",
                                       "--fixed_timestep", "0.02", "--seed", "3", "--csv_logger", log});
    ASSERT_TRUE(succeeds(run)) << run.text();
    const auto table = simulation::readMotionTable(log);
    ASSERT_TRUE(table);
    EXPECT_EQ(table->timeS.size(), 3001u);
    std::size_t present = 0;
    for (const auto& track : table->tracks)
        present += track.samples[1500].has_value();
    EXPECT_GE(present, 45u) << "of fifty, after half a minute";
}

} // namespace
