// SPDX-License-Identifier: Apache-2.0
// A person in an aircraft of a scenario, and persons among what stands in its world.
#include <cmath>

#include "SeatPlay.h"
#include "simulation/contact/ObstacleMap.h"

namespace
{

using namespace seatplay;

/// A house of 12 m by 10 m around a place, up to a height.
SeatStage withHouse(const glm::dvec2& place, double highM, Roads roads)
{
    simulation::Obstacle house;
    house.kind = simulation::ObstacleKind::house;
    house.middle = place;
    house.halfM = {6.0, 5.0};
    house.lowM = -1.0;
    house.highM = highM;
    simulation::ObstacleList list;
    list.add(house, "farm");
    return {std::move(roads), std::make_shared<const simulation::ObstacleMap>(std::move(list))};
}

simulation::SeatSettings inAircraft(const std::filesystem::path& inputs)
{
    return {.entity = "", .isTakenAtStart = true, .vehicle = kAircraftFile, .inputs = inputs};
}

/// Half throttle and the stick pulled a little, from 2 s to 12 s.
const std::string kTaken =
    "osgtrainer-inputs 1\ncolumns time person throttle elevator aileron\n0 0 0.6 0 0\n2 1 0.6 0 0.3\n"
    "12 0 0.6 0 0\nend 40\n";
const std::string kAhead = "osgtrainer-inputs 1\ncolumns time throttle elevator aileron\n0 0.6 0 0\n";

TEST(SeatInAircraft, APersonFliesItAndTheAutopilotGoesOn)
{
    const InputsFile inputs("seat_flies", kTaken);
    const SeatedPlay play = seated(flown(50.0, ""), inAircraft(inputs.path()), {nullptr, nullptr});
    ASSERT_TRUE(play.player);
    EXPECT_EQ(play.player->told()[0].drivenBy, "Autopilot");
    play.playTo(1.9);
    EXPECT_NEAR(play.ego().rollDeg, 0.0, 2.0);
    glm::dvec3 last = play.ego().position;
    double farthestM = 0.0, mostRollDeg = 0.0;
    while (play.player->timeS() < 11.9)
    {
        play.player->step();
        farthestM = std::max(farthestM, glm::distance(play.ego().position, last));
        last = play.ego().position;
        mostRollDeg = std::max(mostRollDeg, std::abs(play.ego().rollDeg));
    }
    EXPECT_EQ(play.player->told()[0].drivenBy, "person");
    // An aircraft that begins in the air has its centre of mass where the reference point was, 1.3 m above
    // it.
    EXPECT_LT(farthestM, 1.5) << "no farther leap when hands change";
    EXPECT_GT(mostRollDeg, 10.0) << "the person rolls it";
    EXPECT_TRUE(play.ego().aircraft);
    EXPECT_TRUE(play.tells("the person takes over"));
    play.playTo(35.0);
    EXPECT_TRUE(play.tells("the person gives it back"));
    EXPECT_EQ(play.player->told()[0].drivenBy, "Autopilot");
    EXPECT_LT(std::abs(play.ego().rollDeg), 10.0) << "the autopilot levels it";
    EXPECT_EQ(play.ego().readings->condition, "sound");
    // The control: without the person it flies straight on.
    const SeatedPlay alone =
        seated(flown(50.0, ""), {.entity = "", .vehicle = kAircraftFile}, {nullptr, nullptr});
    alone.playTo(11.9);
    EXPECT_NEAR(alone.ego().rollDeg, 0.0, 2.0);
}

TEST(SeatInAircraft, RepeatsToTheLastBit)
{
    const InputsFile inputs("seat_flies_again", kTaken);
    const auto end = [&]
    {
        const SeatedPlay play = seated(flown(50.0, ""), inAircraft(inputs.path()), {nullptr, nullptr});
        play.playTo(20.0);
        return play.ego().position;
    };
    EXPECT_EQ(end(), end());
}

/// The aircraft hits what stands in the world of the scenario, and is told as a car is.
TEST(SeatInAircraft, HitsAHouse)
{
    const InputsFile inputs("seat_hits", kAhead);
    const SeatedPlay play =
        seated(flown(50.0, ""), inAircraft(inputs.path()), withHouse({150.0, 0.0}, 1100.0, nullptr));
    ASSERT_TRUE(play.player);
    std::string with;
    while (play.player->timeS() < 6.0)
    {
        play.player->step();
        if (const auto& blow = play.player->told()[0].blow; blow && with.empty())
        {
            with = blow->with;
            EXPECT_NEAR(blow->speedMps, 50.0, 3.0);
            EXPECT_NEAR(blow->courseRad, 0.0, 0.1);
        }
    }
    EXPECT_EQ(with, "farm");
    EXPECT_EQ(play.ego().readings->condition, "crashed");
    EXPECT_LT(play.ego().position.x, 146.0) << "it flew through";
    EXPECT_TRUE(play.tells("into a house (farm)")) << play.player->notes().back();
    const SeatedPlay free = seated(flown(50.0, ""), inAircraft(inputs.path()), {nullptr, nullptr});
    free.playTo(6.0);
    EXPECT_GT(free.ego().position.x, 250.0);
}

/// A car beside its road, among houses.
TEST(SeatAmongHouses, ACarHitsOne)
{
    const InputsFile inputs("seat_house", "osgtrainer-inputs 1\ncolumns time throttle gear\n0 0.3 4\n");
    const SeatedPlay play =
        seated(moving(20.0), {.entity = "", .isTakenAtStart = true, .inputs = inputs.path()},
               withHouse({180.0, -1.75}, 6.0, straight()));
    ASSERT_TRUE(play.player);
    play.playTo(10.0);
    EXPECT_TRUE(play.tells("into a house (farm)"));
    EXPECT_TRUE(play.tells("on a course of 090"));
    EXPECT_LT(play.ego().position.x, 174.0);
    EXPECT_EQ(play.ego().readings->condition, "crashed");
}

} // namespace
