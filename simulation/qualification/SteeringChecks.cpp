// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <foundation/Angle.h>

#include "simulation/qualification/DriveChecks.h"
#include "simulation/qualification/TestDrive.h"
#include "simulation/vehicle/road/SteadyTurn.h"

namespace simulation
{

namespace
{

constexpr double kTurnMps2 =
    1.0; ///< lateral acceleration that a step of the wheel leads to: the linear range
constexpr double kSpeedMps = 25.0;
constexpr double kWatchedS = 6.0;

/// The linear model: a front and a rear wheel, sideslip and yaw.
class SingleTrack
{
public:
    explicit SingleTrack(const RoadVehicleData& vehicle)
        : _mass(massProperties(vehicle)),
          _stiffness(axleStiffness(vehicle)),
          _understeer(understeerOf(vehicle))
    {
        _front = vehicle.axles[0].xM - _mass.centre.x;
        _rear = _mass.centre.x - vehicle.axles[1].xM;
    }

    /// Yaw rate over steering angle in a steady turn.
    double gain(double speedMps) const
    {
        return speedMps / (_front + _rear + _understeer * speedMps * speedMps);
    }

    /// Yaw rates at each step for steering angles at each step.
    std::vector<double> yawRates(const std::vector<double>& steerRad, double speedMps, double stepS) const
    {
        constexpr int kFiner = 20;
        double slip = 0.0, yaw = 0.0;
        std::vector<double> rates;
        for (const double steer : steerRad)
        {
            for (int i = 0; i < kFiner; ++i)
            {
                const double front = _stiffness[0] * (steer - slip - _front * yaw / speedMps);
                const double rear = _stiffness[1] * (-slip + _rear * yaw / speedMps);
                slip += stepS / kFiner * ((front + rear) / (_mass.massKg * speedMps) - yaw);
                yaw += stepS / kFiner * (_front * front - _rear * rear) / _mass.inertiaKgM2.z;
            }
            rates.push_back(yaw);
        }
        return rates;
    }

private:
    RoadMassProperties _mass;
    std::array<double, 2> _stiffness;
    double _understeer;
    double _front = 0.0, _rear = 0.0;
};

/// When a response reaches its peak; where there is none above its end, when it comes within a tenth of that.
double peakTimeS(const std::vector<double>& response, double stepS)
{
    const double last = response.back();
    const auto peak = std::max_element(response.begin(), response.end());
    if (*peak > 1.02 * last) return static_cast<double>(peak - response.begin() + 1) * stepS;
    const auto near =
        std::find_if(response.begin(), response.end(), [last](double r) { return r > 0.9 * last; });
    return static_cast<double>(near - response.begin() + 1) * stepS;
}

} // namespace

QualificationChecks steeringChecks(const std::shared_ptr<const RoadVehicleData>& vehicle)
{
    const SingleTrack model(*vehicle);
    TestDrive drive(vehicle, std::make_shared<const LevelGround>(), kSpeedMps);
    for (int i = 0; i < 360; ++i)
    {
        drive.holdSpeed(kSpeedMps);
        drive.step();
    }
    const double wanted = kTurnMps2 / (kSpeedMps * model.gain(kSpeedMps));
    drive.set(RoadInput::steering, wanted / foundation::radiansOf(vehicle->steering.lockDeg));
    std::vector<double> steered, yawRates;
    while (static_cast<double>(yawRates.size()) * RoadVehicle::kStepS < kWatchedS)
    {
        drive.holdSpeed(kSpeedMps);
        drive.step();
        const RoadReadings readings = drive.vehicle().readings();
        steered.push_back(foundation::radiansOf(readings.steeringWheelDeg) / vehicle->steering.ratio);
        yawRates.push_back(readings.yawRateRadps);
    }
    const std::vector<double> linear = model.yawRates(steered, kSpeedMps, RoadVehicle::kStepS);
    const double expected = model.gain(drive.speedMps());
    const double peakS = peakTimeS(linear, RoadVehicle::kStepS);
    const std::string name = vehicle->name + ": ",
                      source = "linear single-track model of its tyres and masses";
    return {{name + "yaw-rate gain at 90 km/h", yawRates.back() / steered.back(), "1/s", expected,
             0.05 * expected, source},
            {name + "step steer, time to peak", peakTimeS(yawRates, RoadVehicle::kStepS), "s", peakS,
             0.15 * peakS, source}};
}

} // namespace simulation
