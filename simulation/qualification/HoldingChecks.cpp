// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "simulation/qualification/DriveChecks.h"
#include "simulation/qualification/TestDrive.h"

namespace simulation
{

namespace
{

constexpr double kSlope = 0.15;
constexpr double kKerbM = 0.12, kKerbAtM = 150.0, kKerbMps = 70.0;

/// Ground whose height depends on x alone.
class ProfileGround : public Ground
{
public:
    void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            answers[i] = {heightAt(points[i].x), {0.0, 0.0, 1.0}, GroundKind::asphalt, true};
    }

    virtual double heightAt(double x) const = 0;
};

class Slope : public ProfileGround
{
public:
    double heightAt(double x) const override { return kSlope * x; }
};

class Kerb : public ProfileGround
{
public:
    double heightAt(double x) const override { return x < kKerbAtM ? 0.0 : kKerbM; }
};

/// How far it has moved from where it stood after ten seconds.
double creptMm(const std::shared_ptr<const RoadVehicleData>& vehicle, double standsS)
{
    const Slope slope;
    const WeatherAir air;
    RoadVehicle standing(vehicle);
    standing.place({}, slope);
    standing.inputs()[static_cast<std::size_t>(RoadInput::handbrake)] = 1.0;
    const auto stand = [&](double seconds)
    {
        for (int i = 0; i < static_cast<int>(seconds / RoadVehicle::kStepS); ++i)
            standing.step(slope, air);
    };
    stand(10.0);
    const glm::dvec3 start = standing.state().position;
    stand(standsS);
    const bool isSound = standing.status().condition == VehicleCondition::sound;
    return isSound ? 1000.0 * glm::length(standing.state().position - start) : std::nan("");
}

/// How high it has come three seconds after the kerb; not a number where a wheel or the body was under ground
/// meanwhile.
double climbedM(const std::shared_ptr<const RoadVehicleData>& vehicle)
{
    const auto kerb = std::make_shared<const Kerb>();
    TestDrive drive(vehicle, kerb, kKerbMps);
    const double start = drive.vehicle().state().position.z;
    for (int i = 0; i < 600; ++i)
    {
        drive.step();
        const VehicleState state = drive.vehicle().state();
        for (const RoadWheel& wheel : drive.vehicle().wheels())
        {
            const std::size_t index = static_cast<std::size_t>(&wheel - drive.vehicle().wheels().data());
            const AxleData& axle = vehicle->axles[index / 2];
            if (wheel.contact.depthM > axle.tyre.radiusM) return std::nan("");
        }
        if (state.position.z < kerb->heightAt(state.position.x)) return std::nan("");
    }
    return drive.vehicle().state().position.z - start;
}

} // namespace

QualificationChecks holdingChecks(const std::shared_ptr<const RoadVehicleData>& vehicle, double standsS)
{
    return {{vehicle->name + ": creep on a slope of 15 % in " + std::to_string(std::lround(standsS / 60.0)) +
                 " min",
             creptMm(vehicle, standsS), "mm", 0.0, 1.0, "a standing vehicle stands"},
            {vehicle->name + ": climbed by a kerb of 0.12 m at 70 m/s", climbedM(vehicle), "m", kKerbM, 0.02,
             "it comes to stand on the kerb"}};
}

} // namespace simulation
