// SPDX-License-Identifier: Apache-2.0
#include "hud/HudReadings.h"

#include <foundation/Units.h>

#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/road/RoadVehicle.h"

namespace trainer
{

using foundation::kKmhPerMps, foundation::kMetresPerFoot, foundation::kMpsPerKnot, foundation::kMpsPerMph;

namespace
{

std::vector<GaugeKind> flightGauges(HudUnits units)
{
    std::vector<GaugeKind> gauges = {{"IAS kt", 0.0, 160.0, 20.0}, {"ALT ft", 0.0, 10'000.0, 1000.0},
                                     {"HDG", 0.0, 360.0, 45.0},    {"VS ft/min", -2000.0, 2000.0, 500.0},
                                     {"RPM", 0.0, 3000.0, 500.0},  {"FLAPS deg", 0.0, 30.0, 10.0}};
    if (units != HudUnits::metric) return gauges;
    gauges[0] = {"IAS km/h", 0.0, 300.0, 50.0};
    gauges[1] = {"ALT m", 0.0, 3000.0, 500.0};
    gauges[3] = {"VS m/s", -10.0, 10.0, 2.5, 1};
    return gauges;
}

GaugeKind roadSpeed(HudUnits units)
{
    if (units == HudUnits::imperial) return {"SPEED mph", 0.0, 140.0, 20.0};
    return {"SPEED km/h", 0.0, 220.0, 20.0};
}

/// The unit of the road in m/s.
double roadUnitMps(HudUnits units)
{
    return units == HudUnits::imperial ? kMpsPerMph : 1.0 / kKmhPerMps;
}

} // namespace

HudLayout hudLayoutOf(const simulation::DynamicVehicle& vehicle, HudUnits units)
{
    if (dynamic_cast<const simulation::Aircraft*>(&vehicle)) return {flightGauges(units)};
    if (const auto* car = dynamic_cast<const simulation::RoadVehicle*>(&vehicle))
        return {{roadSpeed(units),
                 {"RPM", 0.0, std::ceil(1.1 * car->data().engine.limitRpm / 500.0) * 500.0, 1000.0},
                 {"GEAR", -1.0, static_cast<double>(car->data().gearbox.ratios.size()), 1.0}}};
    return {{{"SPEED km/h", 0.0, 400.0, 50.0}}};
}

std::vector<double> hudValuesOf(const simulation::DynamicVehicle& vehicle, HudUnits units)
{
    if (const auto* aircraft = dynamic_cast<const simulation::Aircraft*>(&vehicle))
    {
        const simulation::FlightReadings now = aircraft->readings();
        const bool isMetric = units == HudUnits::metric;
        return {now.calibratedAirspeedMps / (isMetric ? 1.0 / kKmhPerMps : kMpsPerKnot),
                now.place.heightM / (isMetric ? 1.0 : kMetresPerFoot),
                now.headingDeg,
                now.climbMps / (isMetric ? 1.0 : kMetresPerFoot / 60.0),
                now.engineRpm,
                now.flapDeg};
    }
    if (const auto* car = dynamic_cast<const simulation::RoadVehicle*>(&vehicle))
    {
        const simulation::RoadReadings now = car->readings();
        return {std::abs(now.speedMps) / roadUnitMps(units), now.engineRpm, static_cast<double>(now.gear)};
    }
    return {glm::length(vehicle.state().velocity) * kKmhPerMps};
}

} // namespace trainer
