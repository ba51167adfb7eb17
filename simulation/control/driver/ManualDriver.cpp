// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/driver/ManualDriver.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

#include "simulation/vehicle/road/HandShift.h"
#include "simulation/vehicle/road/SteadyTurn.h"

namespace simulation
{

namespace
{

constexpr double kBendMps2 = 4.0; ///< lateral acceleration that held keys lead to

double inputIn(std::span<const double> inputs, RoadInput input)
{
    return inputs[static_cast<std::size_t>(input)];
}

/// The left foot and the gear lever.
class ClutchFoot
{
public:
    explicit ClutchFoot(const RoadVehicle& vehicle) : _vehicle(&vehicle) {}

    void operator()(std::span<double> inputs)
    {
        const double gear = inputIn(inputs, RoadInput::gear);
        const bool isForward = gear >= 0.5;
        if (isForward && !_wasForward) _hand.begin(*_vehicle);
        _wasForward = isForward;
        RoadInputs next{};
        std::copy(inputs.begin(), inputs.end(), next.begin());
        if (isForward)
            _hand.control(*_vehicle, inputIn(inputs, RoadInput::throttle), next);
        else if (!_vehicle->data().gearbox.isAutomatic)
            next[static_cast<std::size_t>(RoadInput::clutch)] =
                HandShift::clutchAt(_vehicle->readings().engineRpm, _vehicle->data().engine);
        std::copy(next.begin(), next.end(), inputs.begin());
    }

private:
    const RoadVehicle* _vehicle;
    HandShift _hand;
    bool _wasForward = false;
};

} // namespace

ManualController manualDriver(const RoadVehicle& vehicle)
{
    const RoadVehicleData& data = vehicle.data();
    const double lockRad = foundation::radiansOf(data.steering.lockDeg);
    // A bend of the radius speed² / kBendMps2 takes the angle wheelbase / radius, and what understeer adds.
    const double softMps = std::sqrt(kBendMps2 * data.wheelbaseM() / lockRad);
    const double softLeast = kBendMps2 * understeerOf(data) / lockRad;
    std::vector<InputAxis> axes{
        {"steering", -1.0, 1.0, 0.6, 1.2, 0.0, softMps, softLeast},
        {"throttle", 0.0, 1.0, 1.5, 3.0},
        {"brake", 0.0, 1.0, 1.5, 4.0},
        {"handbrake", 0.0, 1.0, 4.0, 4.0, 0.0, 0.0, 0.0, std::nullopt, 1.0},
        {"gear", -1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0},
        {"indicator", -1.0, 1.0, 0.0},
        {"lights", -1.0, 1.0, 0.0},
    };
    auto manual = ManualController::create(std::move(axes), vehicle);
    manual->parkUntil(static_cast<std::size_t>(manual->axisOf("throttle")));
    manual->finishBy(ClutchFoot(vehicle));
    return std::move(*manual);
}

} // namespace simulation
