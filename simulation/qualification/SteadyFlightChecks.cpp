// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <foundation/Angle.h>

#include "simulation/qualification/FlightChecks.h"
#include "simulation/qualification/ReferenceFlight.h"
#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/flight/Trim.h"

namespace simulation
{

namespace
{

/// What a steady flight is told by.
struct SteadyFigures
{
    double throttle = std::nan(""), rpm = std::nan(""), thrustN = std::nan(""), alphaDeg = std::nan("");
};

/// The steady level flight of a recorded row; no numbers where there is none.
SteadyFigures steadyFigures(const AircraftData& aircraft, const FlightRow& row)
{
    const EarthFrame earth(
        {row[FlightChannel::latitudeDeg], row[FlightChannel::longitudeDeg], row[FlightChannel::height]});
    const AirSample air = WeatherAir().at(glm::dvec3(0.0), row[FlightChannel::height], 0.0);
    TrimTarget target;
    target.headingDeg = foundation::degreesOf(row[FlightChannel::heading]);
    target.trueAirspeedMps = row[FlightChannel::airspeed];
    target.mixture = 0.87;
    const foundation::Result<TrimmedFlight> flight = trim(aircraft, earth, air, target);
    if (!flight) return {};
    const glm::dvec3 velocity = glm::conjugate(flight->state.motion.attitude) * flight->state.motion.velocity;
    const PropellerOutput propeller =
        propellerOutput(aircraft.propeller, flight->state.engineRadps, velocity.x, air.densityKgPerM3);
    return {inputOf(flight->inputs, FlightInput::throttle),
            flight->state.engineRadps * 30.0 / std::numbers::pi, propeller.thrustN,
            foundation::degreesOf(std::atan2(velocity.z, velocity.x))};
}

} // namespace

foundation::Result<QualificationChecks> steadyFlightChecks(const AircraftData& aircraft,
                                                           const std::filesystem::path& folder)
{
    QualificationChecks checks;
    for (const char* speed : {"70", "100"})
    {
        const foundation::Result<Flight> flight =
            readReferenceFlight(folder / (std::string("trim_") + speed + "kt.csv.gz"));
        if (!flight) return flight.error();
        const FlightRow& row = flight->front();
        const SteadyFigures own = steadyFigures(aircraft, row);
        const std::string name = std::string("level at ") + speed + " kt: ";
        const char* source = "JSBSim c172p, trimmed at 4000 ft";
        const double rpm = row[FlightChannel::rpm], thrustN = row[FlightChannel::thrust];
        checks.push_back({name + "throttle", own.throttle, "1", row[FlightChannel::throttle], 0.03, source});
        checks.push_back({name + "rpm", own.rpm, "1/min", rpm, 0.03 * rpm, source});
        checks.push_back({name + "thrust", own.thrustN, "N", thrustN, 0.03 * thrustN, source});
        checks.push_back({name + "angle of attack", own.alphaDeg, "deg",
                          foundation::degreesOf(row[FlightChannel::alpha]), 0.3, source});
    }
    return checks;
}

} // namespace simulation
