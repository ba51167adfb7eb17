// SPDX-License-Identifier: Apache-2.0
#include "DrivenVehicle.h"

#include <cmath>

#include "simulation/control/ControlSwitch.h"
#include "simulation/control/ManualControllerFor.h"
#include "simulation/control/scenario/VehicleFiles.h"
#include "simulation/vehicle/WeatherAir.h"

namespace osgSession::core
{

foundation::Result<DrivenVehicle> DrivenVehicle::create(const std::filesystem::path& file,
                                                        std::shared_ptr<const simulation::Ground> ground,
                                                        const std::optional<simulation::Geodetic>& origin,
                                                        std::uint64_t seed)
{
    auto vehicle = simulation::openVehicle(file, origin, seed);
    if (!vehicle) return vehicle.error();
    auto manual = simulation::manualControllerFor(**vehicle);
    if (!manual) return manual.error();
    auto seat = std::make_unique<simulation::ControlSwitch>(nullptr, std::move(*manual), true);
    simulation::ManualController* const seated = &seat->manual();
    auto motion = std::make_shared<simulation::VehicleMotion>(
        std::make_unique<simulation::ControlledVehicle>(std::move(*vehicle), std::move(seat)),
        std::move(ground), std::make_shared<const simulation::WeatherAir>());
    motion->followWeather(origin ? origin->heightM : 0.0, 0.0);
    return DrivenVehicle(std::move(motion), seated);
}

std::vector<std::string> DrivenVehicle::inputs() const
{
    std::vector<std::string> names;
    for (const simulation::InputAxis& axis : _manual->axes())
        names.emplace_back(axis.input);
    return names;
}

foundation::Outcome DrivenVehicle::set(const std::string& input, double value)
{
    const int axis = _manual->axisOf(input);
    if (axis < 0)
    {
        std::string names;
        for (const std::string& name : inputs())
            names += (names.empty() ? "" : ", ") + name;
        return foundation::Error{input, "the vehicle has no such input", "put one of " + names};
    }
    if (std::isnan(value)) return foundation::Error{input, "the value is no number", "put a finite one"};
    _manual->put(static_cast<std::size_t>(axis), value);
    return foundation::success();
}

} // namespace osgSession::core
