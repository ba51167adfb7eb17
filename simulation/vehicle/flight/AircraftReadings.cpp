// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <foundation/Angle.h>

#include "simulation/vehicle/StandardAtmosphere.h"
#include "simulation/vehicle/flight/Aircraft.h"

namespace simulation
{

VehicleState Aircraft::state() const
{
    const BodyMotion& motion = _state.motion;
    const glm::dvec3 rates = motion.rates - glm::conjugate(motion.attitude) * _earth->earthRate();
    // Half a turn about the nose leads from forward, left, up to forward, right, down.
    return {_timeS,
            motion.position,
            motion.velocity,
            motion.attitude * glm::dquat(0.0, 1.0, 0.0, 0.0),
            {rates.x, -rates.y, -rates.z},
            _isOnGround};
}

FlightReadings Aircraft::readings() const
{
    const BodyMotion& motion = _state.motion;
    FlightReadings readings;
    const EarthFrame::Place place = _earth->placeAt(motion.position);
    readings.place = place.geodetic;
    const LevelAngles angles = levelAngles(place, motion.attitude);
    readings.headingDeg = foundation::degreesOf(angles.heading);
    readings.pitchDeg = foundation::degreesOf(angles.pitch);
    readings.rollDeg = foundation::degreesOf(angles.roll);
    const AirSample& air = _surroundings.air;
    const MassProperties mass = massProperties(*_data, _state.fuelKg);
    const FlightLoads loads = flightLoads(*_data, mass, _state, _inputs, _surroundings);
    readings.trueAirspeedMps = loads.air.speedMps;
    readings.calibratedAirspeedMps =
        calibratedAirspeed(loads.air.speedMps, {air.pressurePa, air.temperatureK, air.densityKgPerM3});
    readings.climbMps = glm::dot(motion.velocity, place.up);
    readings.alphaDeg = foundation::degreesOf(loads.air.alpha);
    readings.betaDeg = foundation::degreesOf(loads.air.beta);
    readings.massKg = mass.massKg;
    readings.loadFactor = -loads.load.force.z / (readings.massKg * foundation::kStandardGravityMps2);
    readings.sideLoad = loads.load.force.y / (readings.massKg * foundation::kStandardGravityMps2);
    readings.pressurePa = air.pressurePa;
    readings.heightAboveGroundM = _heightAboveGroundM;
    readings.engineRpm = _state.engineRadps * 30.0 / std::numbers::pi;
    readings.thrustN = loads.propeller.thrustN;
    readings.manifoldPa = _state.manifoldPa;
    readings.fuelKgPerS = loads.engine.fuelKgPerS;
    readings.fuelKg = std::accumulate(_state.fuelKg.begin(), _state.fuelKg.end(), 0.0);
    readings.flapDeg = _state.flapDeg;
    readings.stalled = _state.stalled;
    readings.surfaces = surfaceAngles(*_data, _inputs, _state.flapDeg);
    return readings;
}

double Aircraft::energyJ() const
{
    const MassProperties mass = massProperties(*_data, _state.fuelKg);
    const BodyMotion& motion = _state.motion;
    const double height = _earth->placeAt(motion.position).geodetic.heightM;
    return 0.5 * mass.massKg * glm::dot(motion.velocity, motion.velocity) +
           0.5 * glm::dot(motion.rates, mass.inertia * motion.rates) +
           mass.massKg * foundation::kStandardGravityMps2 * height;
}

} // namespace simulation
