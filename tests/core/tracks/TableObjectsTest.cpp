// SPDX-License-Identifier: Apache-2.0
// Tables with the rows of several aircraft.
#include <gtest/gtest.h>

#include "simulation/track/ReadTrack.h"

namespace simulation
{
namespace
{

struct Table
{
    const char *name, *text;
    std::vector<std::string> tracks; ///< empty: one, named as the file
    std::vector<std::size_t> fixes;
};

class TablesOfSeveral : public testing::TestWithParam<Table>
{
};

TEST_P(TablesOfSeveral, ArePartedByTheColumnThatTellsWhose)
{
    const auto reading = parseTrackTable(GetParam().text, "f.csv");
    ASSERT_TRUE(reading) << reading.error().message();
    std::vector<std::string> names;
    std::vector<std::size_t> fixes;
    for (const FlightTrack& track : reading->tracks)
    {
        names.push_back(track.name);
        fixes.push_back(track.fixes.size());
    }
    EXPECT_EQ(names, GetParam().tracks.empty() ? std::vector<std::string>{"f.csv"} : GetParam().tracks);
    EXPECT_EQ(fixes, GetParam().fixes);
    EXPECT_EQ(reading->notes.size(), names.size() > 1 ? 1u : 0u);
}

INSTANTIATE_TEST_SUITE_P(
    TrackTable, TablesOfSeveral,
    testing::Values(
        // As OpenSky has it: the rows of all by time; one changes its callsign.
        Table{"openSky",
              "time,icao24,lat,lon,velocity,heading,callsign,geoaltitude\n"
              "1000,3c6444,50.0,8.0,200,90,DLH1   ,9000\n1000,4b1801,47.0,8.5,100,10,SWR2,3000\n"
              "1010,3c6444,50.0,8.1,200,90,DLH1,9000\n1010,4b1801,47.01,8.5,100,10,,3000\n"
              "1020,3c6444,50.0,8.2,200,90,DLH9,9000\n1020,4b1801,47.02,8.5,100,10,SWR2,3000\n",
              {"3c6444", "4b1801"},
              {3, 3}},
        Table{"oneAircraftOfTwoFlights",
              "time,icao24,callsign,lat,lon\n0,aa,X1,46,8\n1,aa,X1,46.001,8\n2,aa,X2,46.002,8\n3,aa,X2,46."
              "003,8\n",
              {},
              {4}},
        Table{"oneAfterTheOther",
              "Flight;Time;Latitude;Longitude;Altitude\nAB12;0;46;8;500\nAB12;10;46,01;8;500\n"
              "CD34;0;47;9;600\nCD34;10;47,01;9;600\nCD34;20;47,02;9;600\n",
              {"AB12", "CD34"},
              {2, 3}},
        Table{"tail",
              "t,lat,lon,tail\n0,46,8,N1\n0,46,9,N2\n5,46.01,8,N1\n5,46.01,9,N2\n",
              {"N1", "N2"},
              {2, 2}},
        Table{"rowNumbers", "id,t,lat,lon\n1,0,46,8\n2,1,46.001,8\n3,2,46.002,8\n", {}, {3}},
        Table{"namesOfPoints", "name,lat,lon\nstart,46,8\nturn,46.1,8\nend,46.2,8\n", {}, {3}},
        Table{"vehicleId",
              "timestamp_ms,vehicle "
              "id,latitude,longitude\n0,7,46,8\n0,9,46,8.1\n100,7,46.0001,8\n100,9,46.0001,8.1\n",
              {"7", "9"},
              {2, 2}},
        Table{"emptyCells",
              "time,callsign,lat,lon\n0,A1,46,8\n0,B2,47,8\n5,A1,46.01,8\n5,,47,8\n9,B2,47.02,8\n",
              {"A1", "B2"},
              {2, 2}},
        Table{"afterMidnight",
              "time,hex,lat,lon\n23:59:50,a1,46,8\n23:59:58,a1,46.001,8\n00:00:04,b2,47,8\n00:00:05,a1,46."
              "002,8\n"
              "00:00:09,b2,47.001,8\n",
              {"a1", "b2"},
              {3, 2}}),
    [](const auto& each) { return each.param.name; });

TEST(TablesOfSeveral, TellWhichAreThereAndWhatIsNobodys)
{
    const auto reading = parseTrackTable(
        "time,callsign,lat,lon\n0,A1,46,8\n0,B2,47,8\n5,A1,46.01,8\n5,,47,8\n9,B2,47.02,8\n", "f.csv");
    ASSERT_TRUE(reading);
    ASSERT_EQ(reading->notes.size(), 1u);
    EXPECT_EQ(reading->notes[0].what,
              "2 tracks by the column callsign: A1, B2; --eye-entity NAME looks from another one");
    ASSERT_EQ(reading->problems.size(), 1u);
    EXPECT_EQ(reading->problems[0].line, 5);
}

/// One that is first seen after midnight goes on with the others.
TEST(TablesOfSeveral, HaveOneClock)
{
    const auto reading = parseTrackTable("time,hex,lat,lon\n23:59:50,a1,46,8\n23:59:58,a1,46.001,8\n"
                                         "00:00:04,b2,47,8\n00:00:05,a1,46.002,8\n00:00:09,b2,47.001,8\n",
                                         "f.csv");
    ASSERT_TRUE(reading);
    EXPECT_NEAR(reading->tracks[1].fixes.front().timeS - reading->tracks[0].fixes.front().timeS, 14.0, 1e-6);
}

} // namespace
} // namespace simulation
