// SPDX-License-Identifier: Apache-2.0
// `trainer fly`: flights that repeat, with and without pictures, and what it says of a flight that cannot be.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include "ProgramRun.h"
#include "Workplace.h"
#include "simulation/record/MotionTable.h"

namespace
{

const char* const kFlown = OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml";

std::vector<std::string> flight(std::vector<std::string> more)
{
    std::vector<std::string> all{"fly", "--aircraft", kFlown};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

std::string wholeText(const std::string& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The rows of a table of motion at whole seconds, without their numbers.
std::vector<std::string> rowsAtSeconds(const std::string& file)
{
    std::vector<std::string> rows;
    for (const std::string& line : linesOf(wholeText(file)))
        if (line.find(".000000, Ego") != std::string::npos) rows.push_back(line.substr(line.find(',')));
    return rows;
}

TEST(Fly, RecordedInputsRepeatAFlightToTheLastByte)
{
    const Workplace place;
    const std::string motion = place.path("a.csv"), again = place.path("b.csv"),
                      inputs = place.path("inputs.txt");
    const std::vector<std::string> gusty{"--headless", "--wind",     "270,10", "--gusts",
                                         "1",          "--duration", "20"};
    std::vector<std::string> first = flight(gusty), second = flight(gusty);
    first.insert(first.end(), {"--strip", "0,0,0,800", "--csv_logger", motion, "--record-inputs", inputs});
    second.insert(second.end(), {"--strip", "0,0,0,800", "--csv_logger", again, "--inputs", inputs});
    EXPECT_TRUE(succeeds(runTrainer(first)));
    EXPECT_TRUE(succeeds(runTrainer(second)));
    EXPECT_EQ(wholeText(motion), wholeText(again));
    EXPECT_GT(rowsAtSeconds(motion).size(), 18U);

    // The control: other gusts, other bytes.
    second.insert(second.end(), {"--seed", "2"});
    EXPECT_TRUE(succeeds(runTrainer(second)));
    EXPECT_NE(wholeText(motion), wholeText(again));
}

TEST(Fly, ItsTableTellsBankAirspeedsAndControls)
{
    const Workplace place;
    const std::string motion = place.path("wind.csv");
    // A wind of 20 kt from ahead: through the air it is faster than over the ground.
    EXPECT_TRUE(succeeds(runTrainer(flight({"--headless", "--start", "0,0,1500,0,40", "--wind", "0,20",
                                            "--duration", "2", "--csv_logger", motion}))));
    const std::string table = wholeText(motion);
    for (const char* column : {"World_Roll_Angle [rad]", "True_Airspeed [m/s]", "Calibrated_Airspeed [m/s]",
                               "Input_elevator [-]", "Input_aileron [-]", "Input_rudder [-]",
                               "Input_throttle [-]", "Input_flaps [-]", "Input_left_brake [-]", "Condition"})
        EXPECT_NE(table.find(std::string("#1 ") + column), std::string::npos) << column;
    const auto read = simulation::readMotionTable(motion);
    ASSERT_TRUE(read);
    const auto& last = *read->tracks.front().samples.back();
    ASSERT_TRUE(last.rollRad);
    const std::string row = linesOf(table).back(), header = linesOf(table).at(3);
    const auto cellOf = [&](const std::string& column)
    {
        const auto at = static_cast<std::size_t>(
            std::count(header.begin(), header.begin() + static_cast<long>(header.find(column)), ','));
        std::istringstream stream(row);
        std::string cell;
        for (std::size_t i = 0; i <= at; ++i)
            std::getline(stream, cell, ',');
        return std::atof(cell.c_str());
    };
    const double trueMps = cellOf("#1 True_Airspeed"), calibratedMps = cellOf("#1 Calibrated_Airspeed");
    EXPECT_NEAR(trueMps - last.speedMps, 10.3, 1.5);
    EXPECT_NEAR(calibratedMps / trueMps, 0.93, 0.02); // 1500 m up
    EXPECT_GT(cellOf("#1 Input_throttle"), 0.0);
}

TEST(Fly, AWeatherReportsWindMovesTheAircraft)
{
    const Workplace place;
    const auto northAfter = [&](const std::vector<std::string>& more)
    {
        const std::string motion = place.path("report.csv");
        std::vector<std::string> arguments =
            flight({"--headless", "--start", "0,0,1500,0,40", "--duration", "4", "--csv_logger", motion});
        arguments.insert(arguments.end(), more.begin(), more.end());
        EXPECT_TRUE(succeeds(runTrainer(arguments)));
        const auto read = simulation::readMotionTable(motion);
        EXPECT_TRUE(read);
        return read ? read->tracks.front().samples.back()->position.y : 0.0;
    };
    const double calmM = northAfter({}), reportM = northAfter({"--metar", "LOWI 241150Z 36020KT 9999"}),
                 askedM = northAfter({"--wind", "0,20"});
    EXPECT_GT(std::abs(reportM - calmM),
              0.01); // it starts at one speed over ground; the air takes more of it
    EXPECT_NEAR(reportM, askedM, 0.01);
    // What is asked for goes before the report.
    EXPECT_NEAR(northAfter({"--metar", "LOWI 241150Z 36020KT 9999", "--wind", "180,5"}),
                northAfter({"--wind", "180,5"}), 0.01);
    // Thinner air: the same airspeed is flown with another throttle, and less far.
    EXPECT_GT(std::abs(northAfter({"--metar", "LOWI 241150Z 9999 35/10 Q0980"}) - calmM), 0.01);
}

TEST(Fly, LandsToAStopWithoutPictures)
{
    const ProgramRun run = runTrainer(flight({"--headless", "--strip", "0,0,0,800"}));
    EXPECT_TRUE(succeeds(run));
    EXPECT_NE(run.output.find("at the end on the ground, 0.0 m/s"), std::string::npos) << run.text();
}

TEST(Fly, PicturesAtAnotherRateLeaveTheFlightAsItIs)
{
    const Workplace place;
    const std::string slow = place.path("slow.csv"), fast = place.path("fast.csv"),
                      pictures = place.path("pictures");
    const std::vector<std::string> over{place.hill(), "--start", "0,0,300,90,50", "--size", "64x36",
                                        "--samples",  "1",       "--wind",        "200,15", "--gusts",
                                        "1"};
    std::vector<std::string> first = flight(over), second = flight(over);
    first.insert(first.end(), {"--fps", "2", "--frames", "6", "--csv_logger", slow, "--capture", pictures});
    second.insert(second.end(), {"--fps", "5", "--frames", "15", "--csv_logger", fast});
    EXPECT_TRUE(succeeds(runTrainer(first)));
    EXPECT_TRUE(succeeds(runTrainer(second)));
    const std::vector<std::string> rows = rowsAtSeconds(slow), others = rowsAtSeconds(fast);
    ASSERT_GE(rows.size(), 3U);
    ASSERT_EQ(rows.size(), others.size());
    // All but what is a difference between rows: positions and velocities.
    for (std::size_t i = 0; i < rows.size(); ++i)
        EXPECT_EQ(rows[i].substr(0, rows[i].find("Acc")).substr(0, 240), others[i].substr(0, 240));
    EXPECT_TRUE(std::filesystem::exists(pictures + "/frame_00005.png"));
}

TEST(Fly, TellsWhatCannotBeFlown)
{
    const Workplace place;
    const auto told = [&](std::vector<std::string> more, const std::vector<std::string>& words)
    {
        more.insert(more.end(), {"--headless", "--csv_logger", place.path("none.csv")});
        EXPECT_TRUE(failsWith(runTrainer(flight(more)), 1, "trainer", words));
        EXPECT_FALSE(std::filesystem::exists(place.path("none.csv")));
    };
    told({"--orders", "land"}, {"no runway", "--strip"});
    told({"--orders", "loop"}, {"'loop'", "takeoff"});
    told({"--inputs", place.write("in.txt", "osgtrainer-inputs 1\ncolumns time pull\n0 1\n")},
         {"in.txt", "'pull'", "elevator"});
    told({place.hill(), "--start", "99999,0,0,0,0"}, {"no ground"});
    told({place.hill(), "--start", "0,0,-50,0,50"}, {"inside the ground", "raise it"});
    told({place.hill(), "--strip", "99999,0,0,800"}, {"--strip", "beyond the data"});
    told({place.write("sea.roam", "dem = hill.tif\nsea_level = 1000\n"), "--start", "0,0,0,0,0"}, {"water"});
    const ProgramRun noRunway = runTrainer(flight({place.hill(), "--headless", "--duration", "1"}));
    EXPECT_NE(noRunway.output.find("no runway"), std::string::npos) << noRunway.text();
}

TEST(Fly, DrawsLevelGroundWithoutAWorld)
{
    const Workplace place;
    EXPECT_TRUE(succeeds(
        runTrainer(flight({"--capture", place.path("frames"), "--frames", "1", "--size", "64x36"}))));
    EXPECT_TRUE(std::filesystem::exists(place.path("frames/frame_00000.png")));
}

/// The stand-in for JSBSim flies straight on, and loses itself after half a second where the aircraft is
/// called `dies`.
TEST(Fly, LetsJsbsimFly)
{
    const Workplace place;
    for (const std::string name : {"normal", "dies"})
    {
        std::filesystem::create_directories(place.path("aircraft/" + name));
        std::ofstream(place.path("aircraft/" + name + "/" + name + ".xml")) << "<fdm_config/>";
    }
    const auto flown = [&](const std::string& aircraft, const std::string& program)
    {
        return runTrainer({"fly", "--headless", "--start", "0,0,300,90,50", "--duration", "2",
                           "--jsbsim-root", place.path(""), "--jsbsim", program, "--aircraft", aircraft});
    };
    const ProgramRun run = flown("normal", OSGTRAINER_JSBSIM_STAND_IN);
    EXPECT_TRUE(succeeds(run));
    EXPECT_NE(run.output.find("flown 2.00 s; at the end in the air, 50.0 m/s, 100.0 m east"),
              std::string::npos)
        << run.text();
    const ProgramRun lost = flown("dies", OSGTRAINER_JSBSIM_STAND_IN);
    EXPECT_TRUE(succeeds(lost));
    EXPECT_NE(lost.output.find("note: the aircraft failed after 0.50 s: JSBSim ended"), std::string::npos)
        << lost.text();
    EXPECT_TRUE(failsWith(flown("normal", "no-such-program"), 1, "trainer",
                          {"no-such-program", "cannot be started"}));
    EXPECT_TRUE(failsWith(flown("glider", OSGTRAINER_JSBSIM_STAND_IN), 1, "trainer", {"no such aircraft"}));
}

TEST(Fly, TellsOfACrash)
{
    const Workplace place;
    const std::string dive =
        place.write("dive.txt", "osgtrainer-inputs 1\ncolumns time elevator\n0 1\nend 30\n");
    const ProgramRun run = runTrainer(flight({"--headless", "--inputs", dive}));
    EXPECT_TRUE(succeeds(run));
    EXPECT_NE(run.output.find("note: the aircraft crashed after"), std::string::npos) << run.text();
}

} // namespace
