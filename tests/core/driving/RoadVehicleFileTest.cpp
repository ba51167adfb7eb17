// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>

#include "RoadSupport.h"

namespace
{

using testing::HasSubstr;

std::string vehicleText(const char* name)
{
    std::ifstream stream(testsupport::vehicleFile(name));
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST(RoadVehicleFileTest, ReadsTheVehiclesOfTheTree)
{
    const auto car = testsupport::roadVehicle("car"), van = testsupport::roadVehicle("van"),
               bus = testsupport::roadVehicle("bus");
    EXPECT_NEAR(massProperties(*car).massKg, 1500.0, 1e-9);
    EXPECT_TRUE(car->gearbox.isAutomatic);
    EXPECT_FALSE(van->gearbox.isAutomatic);
    EXPECT_EQ(bus->axles[1].tyresPerSide, 2);
    const auto loads = restLoads(*car);
    EXPECT_NEAR(2.0 * (loads[0] + loads[1]), 1500.0 * 9.80665, 1e-6);
}

TEST(RoadVehicleFileTest, NamesItsLookRelativeToItself)
{
    std::string text = vehicleText("car");
    EXPECT_TRUE(simulation::parseRoadVehicle(text, "folder/car.xml")->lookFile.empty());
    text.replace(text.find("version=\"1\""), 0, "look=\"looks/mine.json\" ");
    const auto car = simulation::parseRoadVehicle(text, "folder/car.xml");
    ASSERT_TRUE(car) << car.error().message();
    EXPECT_EQ(car->lookFile, std::filesystem::path("folder/looks/mine.json"));
}

struct RoadFault
{
    const char* vehicle;
    const char* from;
    const char* to;
    const char* says;
};

class RoadVehicleFault : public testing::TestWithParam<RoadFault>
{
};

// Each fault is told with file, line, what and remedy in one line.
TEST_P(RoadVehicleFault, IsExplained)
{
    std::string text = vehicleText(GetParam().vehicle);
    const std::size_t at = text.find(GetParam().from);
    ASSERT_NE(at, std::string::npos) << GetParam().from;
    text.replace(at, std::string(GetParam().from).size(), GetParam().to);
    const auto vehicle = simulation::parseRoadVehicle(text, "file.xml");
    ASSERT_FALSE(vehicle);
    const std::string message = vehicle.error().message();
    EXPECT_THAT(message, HasSubstr(GetParam().says));
    EXPECT_THAT(message, HasSubstr("file.xml:"));
    EXPECT_THAT(message, HasSubstr("; "));
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Faults, RoadVehicleFault,
    testing::Values(RoadFault{"car", "dragAreaM2=", "dragArea=", "unknown attribute 'dragArea'"},
                    RoadFault{"car", "dragAreaM2=\"0.66\"", "", "has no dragAreaM2"},
                    RoadFault{"car", "massKg=\"1425\"", "massKg=\"nan\"", "massKg is 'nan'"},
                    RoadFault{"car", "source=\"inertia\"", "source=\"nobody\"", "'nobody' is not listed"},
                    RoadFault{"car", "<air ", "<wind ", "<wind> is unknown"},
                    RoadFault{"car", "version=\"1\" name", "version=\"1\" lok=\"a.json\" name",
                              "did you mean look?"},
                    RoadFault{"car", "version=\"1\" name", "version=\"2\" name", "is no <roadVehicle"},
                    RoadFault{"car", "kind=\"automatic\"", "kind=\"robot\"", "kind is 'robot'"},
                    RoadFault{"car", "ratio=\"2.37\"", "ratio=\"4.37\"", "gears that do not fall"},
                    RoadFault{"car", "driveShare=\"1\"", "driveShare=\"0.5\"", "driveShare of both axles"},
                    RoadFault{"car", "brakeShare=\"0.68\"", "brakeShare=\"0.9\"", "brakeShare of both axles"},
                    RoadFault{"car", "tyre=\"205/55 R16\" xM=\"2.7\"", "tyre=\"big\" xM=\"2.7\"",
                              "there is no tyre 'big'"},
                    RoadFault{"car", "xM=\"2.7\"", "xM=\"0.2\"", "the axles lie at"},
                    RoadFault{"car", "xM=\"1.53\"", "xM=\"-3\"", "does not lie between the axles"},
                    RoadFault{"car", "idleRpm=\"750\"", "idleRpm=\"300\"", "do not rise"},
                    RoadFault{"car", "2000 220", "many 220", "has 'many'"},
                    RoadFault{"car", "2000 220", "1000 220", "do not rise"},
                    RoadFault{"van", "clutchNm=\"560\"", "clutchNm=\"0\"", "clutchNm is '0'"},
                    RoadFault{"van", "shiftS=\"0.5\"", "shiftS=\"0.5\" upIdleRpm=\"900\"",
                              "unknown attribute 'upIdleRpm'"},
                    RoadFault{"car", "<performance ", "<performance/><performance ", "names no source"},
                    RoadFault{"car", "</roadVehicle>", "", "not well-formed"}));

TEST(RoadVehicleFileTest, SaysWhenThereIsNoFile)
{
    const auto vehicle = simulation::readRoadVehicle("/nowhere/a.xml");
    ASSERT_FALSE(vehicle);
    EXPECT_THAT(vehicle.error().message(), HasSubstr("no such file"));
}

} // namespace
