// SPDX-License-Identifier: Apache-2.0
#include "simulation/qualification/FlightReplay.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <foundation/Angle.h>

#include "simulation/vehicle/WeatherAir.h"

namespace simulation
{

namespace
{

constexpr double kHalfStepS = 0.5 * Aircraft::kStepS;

void setInputs(std::span<double> inputs, const FlightRow& row, double mixture)
{
    const auto set = [&](FlightInput input, double value)
    { inputs[static_cast<std::size_t>(input)] = value; };
    set(FlightInput::elevator, row[FlightChannel::elevator]);
    set(FlightInput::aileron, row[FlightChannel::aileron]);
    set(FlightInput::rudder, row[FlightChannel::rudder]);
    set(FlightInput::flaps, row[FlightChannel::flaps]);
    set(FlightInput::throttle, row[FlightChannel::throttle]);
    set(FlightInput::mixture, mixture);
}

/// The state of a row, at the origin of its frame.
FlightState stateOf(const AircraftData& data, const EarthFrame& earth, const FlightRow& row)
{
    FlightState state;
    BodyMotion& motion = state.motion;
    const EarthFrame::Place place = earth.geocentricPlaceAt(motion.position);
    motion.attitude = levelAttitude(place, row[FlightChannel::heading], row[FlightChannel::pitch],
                                    row[FlightChannel::roll]);
    const double alpha = row[FlightChannel::alpha], beta = row[FlightChannel::beta];
    motion.velocity = motion.attitude * (row[FlightChannel::airspeed] *
                                         glm::dvec3(std::cos(alpha) * std::cos(beta), std::sin(beta),
                                                    std::sin(alpha) * std::cos(beta)));
    motion.rates =
        glm::dvec3(row[FlightChannel::rollRate], row[FlightChannel::pitchRate], row[FlightChannel::yawRate]) +
        glm::conjugate(motion.attitude) * earth.earthRate();
    state.engineRadps = row[FlightChannel::rpm] * std::numbers::pi / 30.0;
    state.manifoldPa = steadyManifoldPa(data.engine, row[FlightChannel::throttle], state.engineRadps,
                                        standardAtmosphere(row[FlightChannel::height]).pressurePa);
    state.flapDeg = row[FlightChannel::flaps] * data.flaps.fullDeg;
    double dryKg = data.empty.massKg;
    for (const MassPoint& load : data.loads)
        dryKg += load.massKg;
    for (std::size_t i = 0; i < data.tanks.size(); ++i)
        state.fuelKg[i] =
            std::max(0.0, row[FlightChannel::mass] - dryKg) / static_cast<double>(data.tanks.size());
    return state;
}

} // namespace

FlightRow rowOf(const Aircraft& aircraft, double timeS)
{
    const FlightReadings readings = aircraft.readings();
    const VehicleState state = aircraft.state();
    FlightRow row;
    row[FlightChannel::time] = timeS;
    row[FlightChannel::latitudeDeg] = readings.place.latitudeDeg;
    row[FlightChannel::longitudeDeg] = readings.place.longitudeDeg;
    row[FlightChannel::height] = readings.place.heightM;
    const BodyMotion& motion = aircraft.flightState().motion;
    const EarthFrame::Place place = aircraft.earth().geocentricPlaceAt(motion.position);
    const LevelAngles angles = levelAngles(place, motion.attitude);
    row[FlightChannel::roll] = angles.roll;
    row[FlightChannel::pitch] = angles.pitch;
    row[FlightChannel::heading] = angles.heading;
    row[FlightChannel::airspeed] = readings.trueAirspeedMps;
    row[FlightChannel::climb] = glm::dot(motion.velocity, place.up);
    row[FlightChannel::alpha] = foundation::radiansOf(readings.alphaDeg);
    row[FlightChannel::beta] = foundation::radiansOf(readings.betaDeg);
    row[FlightChannel::rollRate] = state.bodyRates.x;
    row[FlightChannel::pitchRate] = -state.bodyRates.y;
    row[FlightChannel::yawRate] = -state.bodyRates.z;
    row[FlightChannel::loadFactor] = readings.loadFactor;
    row[FlightChannel::rpm] = readings.engineRpm;
    row[FlightChannel::thrust] = readings.thrustN;
    row[FlightChannel::mass] = readings.massKg;
    return row;
}

Flight rowsOf(const Flight& flight, const FlightWindow& window)
{
    Flight rows;
    for (const FlightRow& row : flight)
        if (row[FlightChannel::time] > window.startS - kHalfStepS &&
            row[FlightChannel::time] < window.endS + kHalfStepS)
            rows.push_back(row);
    return rows;
}

Flight replay(const std::shared_ptr<const AircraftData>& data, const Flight& reference,
              const FlightWindow& window, double mixture)
{
    const Flight rows = rowsOf(reference, window);
    if (rows.empty()) return {};
    const FlightRow& first = rows.front();
    const auto earth = std::make_shared<const EarthFrame>(Geodetic{
        first[FlightChannel::latitudeDeg], first[FlightChannel::longitudeDeg], first[FlightChannel::height]});
    Aircraft aircraft(data, earth);
    aircraft.place(stateOf(*data, *earth, first));
    const LevelGround ground(-first[FlightChannel::height]);
    const WeatherAir air;
    Flight flown;
    std::int64_t steps = 0;
    for (const FlightRow& row : rows)
    {
        const std::int64_t until =
            std::llround((row[FlightChannel::time] - first[FlightChannel::time]) / Aircraft::kStepS);
        for (; steps < until; ++steps)
            aircraft.step(ground, air);
        if (aircraft.status().condition == VehicleCondition::failed) return flown;
        setInputs(aircraft.inputs(), row, mixture);
        flown.push_back(rowOf(aircraft, row[FlightChannel::time]));
    }
    unwindHeadings(flown);
    return flown;
}

} // namespace simulation
