// SPDX-License-Identifier: Apache-2.0
#include "hud/HudReadings.h"

#include <foundation/Units.h>

#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/road/RoadVehicle.h"

namespace trainer
{

using foundation::kKmhPerMps, foundation::kMetresPerFoot, foundation::kMpsPerKnot;

HudLayout hudLayoutOf(const simulation::DynamicVehicle& vehicle)
{
    if (dynamic_cast<const simulation::Aircraft*>(&vehicle))
        return {{{"IAS kt", 0.0, 160.0, 20.0},
                 {"ALT ft", 0.0, 10'000.0, 1000.0},
                 {"HDG", 0.0, 360.0, 45.0},
                 {"VS ft/min", -2000.0, 2000.0, 500.0},
                 {"RPM", 0.0, 3000.0, 500.0},
                 {"FLAPS deg", 0.0, 30.0, 10.0}}};
    if (const auto* car = dynamic_cast<const simulation::RoadVehicle*>(&vehicle))
        return {{{"SPEED km/h", 0.0, 220.0, 20.0},
                 {"RPM", 0.0, std::ceil(1.1 * car->data().engine.limitRpm / 500.0) * 500.0, 1000.0},
                 {"GEAR", -1.0, static_cast<double>(car->data().gearbox.ratios.size()), 1.0}}};
    return {{{"SPEED km/h", 0.0, 400.0, 50.0}}};
}

std::vector<double> hudValuesOf(const simulation::DynamicVehicle& vehicle)
{
    if (const auto* aircraft = dynamic_cast<const simulation::Aircraft*>(&vehicle))
    {
        const simulation::FlightReadings now = aircraft->readings();
        return {now.calibratedAirspeedMps / kMpsPerKnot,
                now.place.heightM / kMetresPerFoot,
                now.headingDeg,
                now.climbMps / kMetresPerFoot * 60.0,
                now.engineRpm,
                now.flapDeg};
    }
    if (const auto* car = dynamic_cast<const simulation::RoadVehicle*>(&vehicle))
    {
        const simulation::RoadReadings now = car->readings();
        return {std::abs(now.speedMps) * kKmhPerMps, now.engineRpm, static_cast<double>(now.gear)};
    }
    return {glm::length(vehicle.state().velocity) * kKmhPerMps};
}

} // namespace trainer
