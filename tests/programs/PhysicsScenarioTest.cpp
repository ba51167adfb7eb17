// SPDX-License-Identifier: Apache-2.0
// data/scenarios/physics.xosc: a driver, a traffic light and an autopilot in one storyboard.
#include <fstream>
#include <iterator>

#include "ProgramRun.h"
#include "Workplace.h"
#include "simulation/record/MotionTable.h"

namespace
{

const std::string kPhysics = OSGTRAINER_SOURCE_DIR "/data/scenarios/physics.xosc";

std::string textOfFile(const std::string& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST(PhysicsScenario, IsPlayedAsItSaysAndTwiceTheSame)
{
    const Workplace place;
    const std::string log = place.path("physics.csv"), again = place.path("again.csv");
    for (const std::string& file : {log, again})
    {
        const ProgramRun run =
            runTrainer({"play", kPhysics, "--headless", "--fixed_timestep", "0.02", "--csv_logger", file});
        ASSERT_TRUE(succeeds(run)) << run.text();
        EXPECT_EQ(run.output.find("note:"), std::string::npos) << run.output;
    }
    EXPECT_EQ(textOfFile(log), textOfFile(again));
    const auto table = simulation::readMotionTable(log);
    ASSERT_TRUE(table);
    ASSERT_EQ(table->tracks.size(), 3U);
    const auto at = [&](std::size_t entity, double timeS) -> const simulation::MotionSample&
    { return *table->tracks[entity].samples[static_cast<std::size_t>(timeS / 0.02 + 0.5)]; };
    // Until 40 s the light at 500 m is red: the van stands at it, the car behind.
    EXPECT_NEAR(at(1, 39.0).speedMps, 0.0, 0.1);
    EXPECT_NEAR(at(0, 39.0).speedMps, 0.0, 0.1);
    const double vanBackM = at(1, 39.0).position.x + 1.8 - 2.95,
                 carFrontM = at(0, 39.0).position.x + 1.4 + 2.25;
    EXPECT_LT(at(1, 39.0).position.x + 1.8 + 2.95, 500.0);
    EXPECT_GT(vanBackM, carFrontM + 1.0);
    EXPECT_LT(vanBackM, carFrontM + 6.0);
    // Then both drive on; at 70 s the scenario takes the car back and stops it within 20 m.
    EXPECT_GT(at(0, 69.0).speedMps, 10.0);
    EXPECT_DOUBLE_EQ(at(0, 79.0).speedMps, 0.0);
    // The autopilot flew north, then east and up, and the wind of 6 m/s to the east carried it.
    EXPECT_NEAR(at(2, 19.0).position.z, 320.0, 8.0);
    EXPECT_NEAR(at(2, 19.0).position.x, 250.0 + 6.0 * 19.0, 30.0);
    EXPECT_NEAR(at(2, 79.0).position.z, 420.0, 8.0);
    EXPECT_GT(at(2, 79.0).position.x, 1500.0);
}

} // namespace
