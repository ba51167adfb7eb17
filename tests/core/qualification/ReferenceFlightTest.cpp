// SPDX-License-Identifier: Apache-2.0
#include "simulation/qualification/ReferenceFlight.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>

namespace
{

using namespace simulation;
using testing::HasSubstr;

const std::string kHead =
    "Time,lat_deg,lon_deg,alt_msl_ft,agl_ft,roll_rad,pitch_rad,heading_rad,tas_fps,cas_kt,climb_fps,"
    "alpha_rad,beta_rad,p_rad_s,q_rad_s,r_rad_s,nz,elevator_cmd,pitch_trim_cmd,aileron_cmd,"
    "rudder_cmd,flap_norm,throttle,rpm,thrust_lbs,weight_lbs\n";
const std::string kRow = ",47,8,1000,1000,0.1,0.2,6.2,100,90,1,0,0,0,0,0,1,0.1,0.2,0,0,0,0.5,2000,100,1880\n";

foundation::Result<Flight> readText(const std::string& text)
{
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "reference_flight.csv";
    std::ofstream(file) << text;
    return readReferenceFlight(file);
}

TEST(ReferenceFlightTest, ReadsSiUnitsAndLeavesOutTheRowBeforeTrim)
{
    std::string later = kRow;
    later.replace(later.find("6.2"), 3, "0.1");
    const auto flight = readText(kHead + "0" + kRow + "0.1" + kRow + "0.2" + later);
    ASSERT_TRUE(flight) << flight.error().message();
    ASSERT_EQ(flight->size(), 2U);
    const FlightRow& row = flight->front();
    EXPECT_DOUBLE_EQ(row[FlightChannel::time], 0.1);
    EXPECT_DOUBLE_EQ(row[FlightChannel::height], 304.8);
    EXPECT_DOUBLE_EQ(row[FlightChannel::airspeed], 30.48);
    EXPECT_NEAR(row[FlightChannel::elevator], 0.3, 1e-15) << "command and trim together";
    EXPECT_NEAR(row[FlightChannel::mass], 852.75, 0.01);
    EXPECT_NEAR(flight->back()[FlightChannel::heading], 0.1 + 6.28319, 1e-4)
        << "through north without a jump";
}

TEST(ReferenceFlightTest, ExplainsWhatIsWrong)
{
    EXPECT_THAT(readText("Time,lat_deg\n0,1\n").error().message(), HasSubstr("has no column 'lon_deg'"));
    EXPECT_THAT(readText(kHead + "0" + kRow + "0.1,47\n").error().message(),
                HasSubstr(":3: has 2 fields of 26"));
    EXPECT_THAT(readText(kHead + "0" + kRow + "abc" + kRow).error().message(),
                HasSubstr("'abc' is no number"));
    EXPECT_THAT(readText(kHead).error().message(), HasSubstr("has no rows"));
    EXPECT_THAT(readReferenceFlight("/nowhere.csv").error().message(), HasSubstr("no such file"));
}

} // namespace
