// SPDX-License-Identifier: Apache-2.0
#include "view/CockpitReadings.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>
#include <foundation/Units.h>

#include "scenery/nodes/DefaultAircraft.h"
#include "simulation/vehicle/StandardAtmosphere.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/road/RoadVehicle.h"

namespace trainer
{

namespace
{

using scenery::models::EntityLamp;
using scenery::models::Reading;
using scenery::models::Readings;

constexpr double kFullShare = 0.75, kDefaultSteeringRatio = 15.0, kLeastTurnMps = 5.0, kBallG = 0.1;

bool isLit(const CockpitState& state, EntityLamp::Kind lamp)
{
    return state.lamps[static_cast<std::size_t>(lamp)];
}

/// Of what moves without physics, a turn without slip.
double coordinatedTurnDegps(const simulation::EntityState& entity)
{
    if (std::abs(entity.speedMps) < kLeastTurnMps) return 0.0;
    return foundation::degreesOf(foundation::kStandardGravityMps2 *
                                 std::tan(foundation::radiansOf(std::clamp(entity.rollDeg, -80.0, 80.0))) /
                                 entity.speedMps);
}

void addMotion(const CockpitState& state, Readings& readings)
{
    const simulation::EntityState& entity = state.entity;
    readings[Reading::airspeedKt] = entity.speedMps / foundation::kMpsPerKnot;
    readings[Reading::pitchDeg] = -entity.pitchDeg;
    readings[Reading::rollDeg] = entity.rollDeg;
    const double heightM = entity.position.z + state.seaHeightM;
    const double pressurePa = simulation::standardAtmosphere(heightM).pressurePa;
    readings[Reading::altitudeFt] =
        simulation::altimeterHeight(pressurePa, 100.0 * state.altimeterHpa) / foundation::kMetresPerFoot;
    readings[Reading::altimeterHpa] = state.altimeterHpa;
    readings[Reading::turnDegps] = coordinatedTurnDegps(entity);
    readings[Reading::headingDeg] = entity.compassDeg();
    readings[Reading::climbFpm] = entity.velocity.z / foundation::kMetresPerFoot * 60.0;
    readings[Reading::fuelLeft] = readings[Reading::fuelRight] = readings[Reading::fuel] = kFullShare;
    if (!state.flies) return;
    const simulation::AircraftParts parts =
        entity.aircraft ? *entity.aircraft : scenery::defaultAircraftParts(entity, false);
    readings[Reading::propellerRadps] = parts.propellerRadps;
    readings[Reading::propellerTurnDeg] = parts.propellerTurnDeg;
    readings[Reading::engineRpm] = foundation::degreesOf(parts.propellerRadps) / 6.0; // a turn is 360 degrees
    readings[Reading::flapDeg] = parts.flapDeg;
}

void addFlight(const simulation::Aircraft& aircraft, const CockpitState& state, Readings& readings)
{
    const simulation::FlightReadings now = aircraft.readings();
    readings[Reading::airspeedKt] = now.calibratedAirspeedMps / foundation::kMpsPerKnot;
    readings[Reading::pitchDeg] = now.pitchDeg;
    readings[Reading::rollDeg] = now.rollDeg;
    readings[Reading::altitudeFt] =
        simulation::altimeterHeight(now.pressurePa, 100.0 * state.altimeterHpa) / foundation::kMetresPerFoot;
    const simulation::VehicleState moving = aircraft.state();
    readings[Reading::turnDegps] = -foundation::degreesOf((moving.bodyToScene * moving.bodyRates).z);
    readings[Reading::slip] = -now.sideLoad / kBallG;
    readings[Reading::headingDeg] = now.headingDeg;
    readings[Reading::climbFpm] = now.climbMps / foundation::kMetresPerFoot * 60.0;
    readings[Reading::engineRpm] = now.engineRpm;
    readings[Reading::flapDeg] = now.flapDeg;
    readings[Reading::trim] =
        -simulation::inputOf(aircraft.flightInputs(), simulation::FlightInput::elevatorTrim);
    const auto& tanks = aircraft.data().tanks;
    const auto share = [&](std::size_t tank)
    {
        return tank < tanks.size() && tanks[tank].capacityKg > 0.0
                   ? aircraft.flightState().fuelKg[tank] / tanks[tank].capacityKg
                   : 0.0;
    };
    readings[Reading::fuelLeft] = share(0);
    readings[Reading::fuelRight] = share(tanks.size() > 1 ? 1 : 0);
}

/// Gears and revs of an engine as cars have it.
void addDefaultEngine(double speedMps, Readings& readings)
{
    constexpr double kIdleRpm = 800.0, kRpmPerMps[] = {390.0, 220.0, 145.0, 108.0, 86.0}, kUpRpm = 2800.0;
    const double forward = std::abs(speedMps);
    std::size_t gear = 0;
    while (gear + 1 < std::size(kRpmPerMps) && forward * kRpmPerMps[gear] > kUpRpm)
        ++gear;
    readings[Reading::engineRpm] = std::max(kIdleRpm, forward * kRpmPerMps[gear]);
    readings[Reading::gear] = speedMps < -0.1 ? -1.0 : forward < 0.1 ? 0.0 : static_cast<double>(gear + 1);
}

void addDrive(const CockpitState& state, Readings& readings)
{
    readings[Reading::speedKmh] = std::abs(state.entity.speedMps) * foundation::kKmhPerMps;
    readings[Reading::steeringWheelDeg] = kDefaultSteeringRatio * state.entity.steeringDeg;
    readings[Reading::indicatorLeft] = isLit(state, EntityLamp::Kind::indicatorLeft) ? 1.0 : 0.0;
    readings[Reading::indicatorRight] = isLit(state, EntityLamp::Kind::indicatorRight) ? 1.0 : 0.0;
    readings[Reading::headLamps] = isLit(state, EntityLamp::Kind::head) ? 1.0 : 0.0;
    const auto* const car = dynamic_cast<const simulation::RoadVehicle*>(state.vehicle);
    if (!car) return addDefaultEngine(state.entity.speedMps, readings);
    const simulation::RoadReadings now = car->readings();
    readings[Reading::speedKmh] = std::abs(now.speedMps) * foundation::kKmhPerMps;
    readings[Reading::engineRpm] = now.engineRpm;
    readings[Reading::gear] = now.gear;
    readings[Reading::steeringWheelDeg] = now.steeringWheelDeg;
    readings[Reading::handbrake] = simulation::inputOf(car->roadInputs(), simulation::RoadInput::handbrake);
}

} // namespace

Readings cockpitReadings(const CockpitState& state)
{
    Readings readings;
    addMotion(state, readings);
    if (const auto* const aircraft = dynamic_cast<const simulation::Aircraft*>(state.vehicle))
        addFlight(*aircraft, state, readings);
    else if (!state.flies)
        addDrive(state, readings);
    return readings;
}

} // namespace trainer
