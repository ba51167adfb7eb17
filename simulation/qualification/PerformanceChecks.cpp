// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "simulation/qualification/DriveChecks.h"
#include "simulation/qualification/TestDrive.h"
#include "simulation/vehicle/StandardAtmosphere.h"
#include "simulation/vehicle/road/Tyre.h"

namespace simulation
{

namespace
{

constexpr double kKmh = 1.0 / 3.6;

std::shared_ptr<const Ground> asphalt()
{
    return std::make_shared<const LevelGround>(0.0, GroundKind::asphalt);
}

double accelerationTimeS(const std::shared_ptr<const RoadVehicleData>& vehicle)
{
    TestDrive drive(vehicle, asphalt(), 0.0);
    const double start = drive.timeS();
    while (drive.timeS() - start < 120.0)
    {
        drive.accelerate();
        drive.step();
        if (drive.speedMps() >= vehicle->performance.toKmh * kKmh) return drive.timeS() - start;
    }
    return std::nan("");
}

/// A full braking, from the pedal to the standstill.
class Braking
{
public:
    Braking(const std::shared_ptr<const RoadVehicleData>& vehicle, GroundKind kind, double fromMps)
        : _drive(vehicle, std::make_shared<const LevelGround>(0.0, kind), fromMps)
    {
        _drive.set(RoadInput::throttle, 0.0);
        _drive.set(RoadInput::clutch, 1.0);
        _drive.set(RoadInput::brake, 1.0);
    }

    /// The distance until a speed is reached; not a number when it is not within two minutes.
    double distanceToM(double speedMps)
    {
        const glm::dvec3 start = _drive.vehicle().state().position;
        for (int i = 0; i < 120 * 120; ++i)
        {
            if (_drive.speedMps() < speedMps) return glm::length(_drive.vehicle().state().position - start);
            _drive.step();
        }
        return std::nan("");
    }

private:
    TestDrive _drive;
};

/// The distance over which the brakes, once they grip, bring a vehicle from 20 to 2 m/s.
double grippedDistanceM(const std::shared_ptr<const RoadVehicleData>& vehicle, GroundKind kind)
{
    Braking braking(vehicle, kind, 24.0);
    return braking.distanceToM(20.0) > 0.0 ? braking.distanceToM(2.0) : std::nan("");
}

/// The largest lateral acceleration, g, while the wheel is turned slowly at a steady speed: the mean of one
/// second.
double lateralG(const std::shared_ptr<const RoadVehicleData>& vehicle)
{
    constexpr double kSpeedMps = 60.0 * kKmh;
    constexpr std::size_t kMeanSteps = 120;
    TestDrive drive(vehicle, asphalt(), kSpeedMps);
    std::array<double, kMeanSteps> window{};
    double most = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < 120 * 40; ++i)
    {
        drive.holdSpeed(kSpeedMps);
        drive.set(RoadInput::steering, std::min(1.0, static_cast<double>(i) / (120.0 * 30.0)));
        drive.step();
        const RoadReadings readings = drive.vehicle().readings();
        const double now = readings.accelerationMps2.y / foundation::kStandardGravityMps2;
        sum += now - window[i % kMeanSteps];
        window[i % kMeanSteps] = now;
        if (drive.vehicle().status().condition != VehicleCondition::sound) return std::nan("");
        most = std::max(most, sum / static_cast<double>(kMeanSteps));
    }
    return most;
}

/// What all tyres together can brake at their peaks: their friction at the loads that the braking itself
/// makes. Units: m/s².
double mostDeceleration(const RoadVehicleData& vehicle, double gripFactor)
{
    const RoadMassProperties mass = massProperties(vehicle);
    const std::array<double, 2> rest = restLoads(vehicle);
    double deceleration = 0.0;
    for (int round = 0; round < 50; ++round)
    {
        const double moved = 0.5 * mass.massKg * deceleration * mass.centre.z / vehicle.wheelbaseM();
        double force = 0.0;
        for (std::size_t i = 0; i < 2; ++i)
        {
            const double load = (rest[i] + (i == 0 ? moved : -moved)) / vehicle.axles[i].tyresPerSide;
            force += 2.0 * vehicle.axles[i].tyresPerSide * load *
                     tyreFriction(vehicle.axles[i].tyre, load, gripFactor).x;
        }
        deceleration = force / mass.massKg;
    }
    return deceleration;
}

/// The distance from 20 to 2 m/s with the tyres at their peaks and the drag of the air.
double idealDistanceM(const RoadVehicleData& vehicle, double gripFactor)
{
    constexpr double kSliceMps = 0.01;
    const double tyres = mostDeceleration(vehicle, gripFactor);
    const double drag = 0.5 * kSeaDensity * vehicle.air.dragAreaM2 / massProperties(vehicle).massKg;
    double distance = 0.0;
    for (double speed = 2.0 + 0.5 * kSliceMps; speed < 20.0; speed += kSliceMps)
        distance += speed * kSliceMps / (tyres + drag * speed * speed);
    return distance;
}

} // namespace

QualificationChecks performanceChecks(const std::shared_ptr<const RoadVehicleData>& vehicle)
{
    const PerformanceData& reached = vehicle->performance;
    const std::string name = vehicle->name + ": ", source = "figures of the class, in its file";
    const std::string speed = std::to_string(static_cast<int>(reached.toKmh));
    return {{name + "0-" + speed + " km/h", accelerationTimeS(vehicle), "s", reached.accelerateS,
             reached.accelerateToleranceS, source},
            {name + "100-0 km/h", Braking(vehicle, GroundKind::asphalt, 100.0 * kKmh).distanceToM(0.01), "m",
             reached.stopM, reached.stopToleranceM, source},
            {name + "lateral acceleration", lateralG(vehicle), "g", reached.lateral, reached.lateralTolerance,
             source}};
}

QualificationChecks frictionChecks(const std::shared_ptr<const RoadVehicleData>& vehicle)
{
    QualificationChecks checks;
    for (const auto& [kind, ground] :
         {std::pair(GroundKind::asphalt, "dry asphalt"), std::pair(GroundKind::wetAsphalt, "wet asphalt"),
          std::pair(GroundKind::gravel, "gravel"), std::pair(GroundKind::grass, "grass"),
          std::pair(GroundKind::snow, "snow")})
    {
        const double expected = idealDistanceM(*vehicle, frictionOf(kind).gripFactor);
        checks.push_back({vehicle->name + ": 20-2 m/s on " + ground, grippedDistanceM(vehicle, kind), "m",
                          expected, 0.03 * expected, "friction of the tyres at their loads, and drag"});
    }
    return checks;
}

} // namespace simulation
