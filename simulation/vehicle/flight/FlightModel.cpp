// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/FlightModel.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

namespace simulation
{

namespace
{

/// Force and moments of a turning propeller: thrust at a point that moves with the inflow's angle, and the
/// reaction to its torque. The moving point stands for the uneven load of the disc in oblique air.
ForceMoment propellerLoad(const PropellerData& propeller, const PropellerOutput& output,
                          const glm::dvec3& velocity, const glm::dvec3& arm)
{
    const double tangential = std::hypot(velocity.y, velocity.z);
    glm::dvec3 point = arm;
    if (tangential > 1e-4)
    {
        const double angle = std::atan2(tangential, velocity.x + output.inducedVelocityMps);
        const double shift = propeller.turnsRight * propeller.discShiftMPerRad * angle / tangential;
        point += glm::dvec3(0.0, shift * velocity.z, -shift * velocity.y);
    }
    const glm::dvec3 thrust(output.thrustN, 0.0, 0.0);
    return {thrust, glm::cross(point, thrust) - glm::dvec3(propeller.turnsRight * output.torqueNm, 0.0, 0.0)};
}

bool hasFuel(const FlightState& state)
{
    return std::any_of(state.fuelKg.begin(), state.fuelKg.end(), [](double kg) { return kg > 0.0; });
}

} // namespace

SurfaceAngles surfaceAngles(const AircraftData& aircraft, const FlightInputs& inputs, double flapDeg)
{
    const auto angle = [&](const SurfaceTravel& travel, FlightInput input, FlightInput trim)
    { return foundation::radiansOf(travel.degreesAt(trimmedInputOf(inputs, input, trim))); };
    return {angle(aircraft.elevator, FlightInput::elevator, FlightInput::elevatorTrim),
            angle(aircraft.aileron, FlightInput::aileron, FlightInput::aileronTrim),
            angle(aircraft.rudder, FlightInput::rudder, FlightInput::rudderTrim), flapDeg};
}

FlightLoads flightLoads(const AircraftData& aircraft, const MassProperties& mass, const FlightState& state,
                        const FlightInputs& inputs, const FlightSurroundings& surroundings)
{
    const glm::dquat toBody = glm::conjugate(state.motion.attitude);
    const AirSample& sample = surroundings.air;
    FlightLoads loads;
    loads.air = airDataOf(toBody * (state.motion.velocity - sample.windMps) - surroundings.gust,
                          state.motion.rates - toBody * surroundings.earthRate - surroundings.gustRates,
                          sample.densityKgPerM3);
    loads.air.alphaRate = state.alphaRate;
    loads.propeller =
        propellerOutput(aircraft.propeller, state.engineRadps, loads.air.velocity.x, sample.densityKgPerM3);
    loads.engine = engineOutput(
        aircraft.engine,
        {inputOf(inputs, FlightInput::throttle), inputOf(inputs, FlightInput::mixture),
         inputOf(inputs, FlightInput::ignition), inputOf(inputs, FlightInput::starter), hasFuel(state)},
        state.engineRadps, state.manifoldPa, sample);
    const double slipstream = loads.air.velocity.x + 2.0 * loads.propeller.inducedVelocityMps;
    const FlowState flow{state.stalled, surroundings.heightOverSpan,
                         0.5 * sample.densityKgPerM3 * slipstream * slipstream};
    loads.load = aerodynamicForces(aircraft, loads.air, surfaceAngles(aircraft, inputs, state.flapDeg), flow,
                                   bodyPlace(aircraft.aerodynamicPoint, mass.centre));
    loads.load += propellerLoad(aircraft.propeller, loads.propeller, loads.air.velocity,
                                bodyPlace(aircraft.propeller.place, mass.centre));
    return loads;
}

} // namespace simulation
