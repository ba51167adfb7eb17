// SPDX-License-Identifier: Apache-2.0
// The figures of docs/algorithms/driving.md, and for each a vehicle that does not reach it.
#include "simulation/qualification/DriveChecks.h"

#include <functional>
#include <set>

#include "RoadSupport.h"

namespace
{

using namespace simulation;

constexpr double kStandsS = 60.0;

QualificationChecks allChecks(const RoadVehicleData& data)
{
    const auto vehicle = std::make_shared<const RoadVehicleData>(data);
    QualificationChecks all;
    for (const QualificationChecks& checks : {performanceChecks(vehicle), steeringChecks(vehicle),
                                              frictionChecks(vehicle), holdingChecks(vehicle, kStandsS)})
        all.insert(all.end(), checks.begin(), checks.end());
    return all;
}

class DriveChecksOf : public testing::TestWithParam<const char*>
{
};

TEST_P(DriveChecksOf, AllPass)
{
    const QualificationChecks checks = allChecks(*testsupport::roadVehicle(GetParam()));
    EXPECT_EQ(checks.size(), 12U);
    for (const QualificationCheck& check : checks)
    {
        EXPECT_TRUE(check.passes()) << check.name << ": " << check.value << " for " << check.expected
                                    << " +- " << check.tolerance;
        EXPECT_FALSE(check.source.empty());
    }
}

INSTANTIATE_TEST_SUITE_P(Vehicles, DriveChecksOf, testing::ValuesIn(testsupport::kVehicleNames));

// Cars that are wrong in one thing each; the model that they are compared with is that of the file in use, so
// what fails the check of a law is a car that leaves the law's range.
TEST(DriveChecksTest, EachCanFail)
{
    const std::vector<std::function<void(RoadVehicleData&)>> faults{
        [](RoadVehicleData& c) { c.engine.fullTorqueNm = c.engine.fullTorqueNm.scaled(0.6); },
        [](RoadVehicleData& c) { c.brakes.mostNm = 1200.0; },
        [](RoadVehicleData& c) { c.brakes.absSlip = 0.0; },
        [](RoadVehicleData& c) { c.brakes.handbrakeNm = 200.0; },
        [](RoadVehicleData& c) { c.axles[0].tyre.frictionAcross = c.axles[1].tyre.frictionAcross = 0.6; },
        [](RoadVehicleData& c) { c.axles[0].steersShare = 0.8; },
        [](RoadVehicleData& c)
        { c.axles[0].tyre.relaxationAcrossM = c.axles[1].tyre.relaxationAcrossM = 3.0; },
        [](RoadVehicleData& c) { c.axles[0].tyre.springNPerM = c.axles[1].tyre.springNPerM = 2e4; }};
    std::set<std::string> unfailed;
    for (const QualificationCheck& check : allChecks(*testsupport::roadVehicle()))
        EXPECT_TRUE(unfailed.insert(check.name).second) << check.name << " is there twice";
    for (const auto& fault : faults)
    {
        RoadVehicleData wrong = *testsupport::roadVehicle();
        fault(wrong);
        for (const QualificationCheck& check : allChecks(wrong))
            if (!check.passes()) unfailed.erase(check.name);
    }
    for (const std::string& name : unfailed)
        ADD_FAILURE() << name << " passes whatever the car is";
}

} // namespace
