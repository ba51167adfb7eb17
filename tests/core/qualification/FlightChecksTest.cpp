// SPDX-License-Identifier: Apache-2.0
// The figures of docs/algorithms/flight.md, and for each an aircraft that does not reach it.
#include "simulation/qualification/FlightChecks.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "RealData.h"
#include "simulation/vehicle/flight/AircraftFile.h"

namespace
{

using namespace simulation;

AircraftData lightSingle()
{
    const auto read = readAircraft(OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml");
    EXPECT_TRUE(read) << read.error().message();
    return *read;
}

void scale(AircraftData& aircraft, Part part, double factor)
{
    CoefficientTable& coefficient = aircraft.coefficients[static_cast<std::size_t>(part)];
    coefficient.table = coefficient.table.scaled(factor);
}

/// Aircraft that are wrong in one thing each.
std::vector<AircraftData> wrongAircraft()
{
    const std::vector<std::function<void(AircraftData&)>> faults{
        [](AircraftData& a) { scale(a, Part::lift, 0.7); },
        [](AircraftData& a) { scale(a, Part::drag, 1.5); },
        [](AircraftData& a) { scale(a, Part::dragAlpha, 2.0); },
        [](AircraftData& a) { scale(a, Part::pitchAlpha, 0.5); },
        [](AircraftData& a) { scale(a, Part::pitchElevator, 0.7); },
        [](AircraftData& a) { scale(a, Part::rollAileron, 0.7); },
        [](AircraftData& a) { scale(a, Part::roll, 2.0); },
        [](AircraftData& a) { scale(a, Part::yaw, 1.6); },
        [](AircraftData& a) { scale(a, Part::yawYawRate, 2.0); },
        [](AircraftData& a) { scale(a, Part::yawRudder, 0.7); },
        [](AircraftData& a) { scale(a, Part::rollRollRate, 0.7); },
        [](AircraftData& a) { a.engine.volumetricEfficiency *= 0.8; },
        [](AircraftData& a) { a.engine.manifoldLagS = 4.0; },
        [](AircraftData& a) { a.propeller.thrust = a.propeller.thrust.scaled(1.3); },
        [](AircraftData& a) { a.propeller.power = a.propeller.power.scaled(1.3); }};
    std::vector<AircraftData> aircraft;
    for (const auto& fault : faults)
        fault(aircraft.emplace_back(lightSingle()));
    return aircraft;
}

using Checks = std::function<foundation::Result<QualificationChecks>(const AircraftData&)>;

/// All pass for the aircraft of the tree, and each fails for one of the others.
void expectChecksThatCanFail(const Checks& checksOf)
{
    const auto checks = checksOf(lightSingle());
    ASSERT_TRUE(checks) << checks.error().message();
    std::set<std::string> unfailed;
    for (const QualificationCheck& check : *checks)
    {
        EXPECT_TRUE(check.passes()) << check.name << ": " << check.value << " for " << check.expected
                                    << " +- " << check.tolerance;
        EXPECT_TRUE(unfailed.insert(check.name).second) << check.name << " is there twice";
        EXPECT_FALSE(check.source.empty());
    }
    for (const AircraftData& aircraft : wrongAircraft())
    {
        if (unfailed.empty()) return;
        const auto others = checksOf(aircraft);
        ASSERT_TRUE(others);
        for (const QualificationCheck& check : *others)
            if (!check.passes()) unfailed.erase(check.name);
    }
    for (const std::string& name : unfailed)
        ADD_FAILURE() << name << " passes whatever the aircraft is";
}

TEST(FlightChecksTest, PerformanceIsTheHandbooksAndCanFail)
{
    Checks checks = [](const AircraftData& aircraft) -> foundation::Result<QualificationChecks>
    {
        QualificationChecks all = handbookChecks(aircraft);
        std::erase_if(all, [](const QualificationCheck& check)
                      { return check.name.find("turn") != std::string::npos; });
        return all;
    };
    expectChecksThatCanFail(checks);
}

// The rate of a turn is a law of mechanics: an aircraft that cannot bank so far at that speed is its control.
TEST(FlightChecksTest, TheRateOfTurnIsThatOfItsBankAndCanFail)
{
    const auto turn = [](const AircraftData& aircraft)
    {
        for (const QualificationCheck& check : handbookChecks(aircraft))
            if (check.name.find("turn") != std::string::npos) return check.passes();
        return false;
    };
    EXPECT_TRUE(turn(lightSingle()));
    AircraftData weak = lightSingle();
    scale(weak, Part::lift, 0.2);
    EXPECT_FALSE(turn(weak));
}

TEST(FlightChecksTest, SteadyFlightsAreTheRecordedOnesAndCanFail)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "jsbsim/c172p-response");
    expectChecksThatCanFail([&](const AircraftData& aircraft)
                            { return steadyFlightChecks(aircraft, folder); });
}

TEST(FlightChecksTest, ResponsesAreTheRecordedOnesAndCanFail)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "jsbsim/c172p-response");
    expectChecksThatCanFail(
        [&](const AircraftData& aircraft)
        { return responseChecks(std::make_shared<const AircraftData>(aircraft), folder); });
}

TEST(FlightChecksTest, OscillationsAreTheRecordedOnesAndCanFail)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "jsbsim/c172p-response");
    expectChecksThatCanFail(
        [&](const AircraftData& aircraft)
        { return oscillationChecks(std::make_shared<const AircraftData>(aircraft), folder); });
}

} // namespace
