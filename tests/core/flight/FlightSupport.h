// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "simulation/vehicle/ProvidedGround.h"
#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/flight/AircraftFile.h"
#include "simulation/vehicle/flight/Trim.h"

namespace testsupport
{

inline const char* const kAircraftFile = OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml";
inline constexpr double kKnot = 1852.0 / 3600.0;

/// The aircraft of the tree; a file that cannot be read fails the test.
inline std::shared_ptr<const simulation::AircraftData> lightSingle()
{
    static const auto read = simulation::readAircraft(kAircraftFile);
    EXPECT_TRUE(read) << read.error().message();
    return std::make_shared<const simulation::AircraftData>(*read);
}

/// The Earth at 46 N 8 E, the scene's origin at sea level.
inline std::shared_ptr<const simulation::EarthFrame> earthHere()
{
    return std::make_shared<const simulation::EarthFrame>(simulation::Geodetic{46.0, 8.0, 0.0});
}

inline void setInput(simulation::Aircraft& aircraft, simulation::FlightInput input, double value)
{
    aircraft.inputs()[static_cast<std::size_t>(input)] = value;
}

inline double input(const simulation::FlightInputs& inputs, simulation::FlightInput which)
{
    return inputs[static_cast<std::size_t>(which)];
}

/// An aircraft put into a steady flight.
inline simulation::Aircraft flying(const simulation::TrimmedFlight& flight)
{
    simulation::Aircraft aircraft(lightSingle(), earthHere());
    aircraft.place(flight.state);
    std::copy(flight.inputs.begin(), flight.inputs.end(), aircraft.inputs().begin());
    return aircraft;
}

inline simulation::AirSample airAt(double heightM)
{
    return simulation::WeatherAir().at(glm::dvec3(0.0), heightM, 0.0);
}

/// The aircraft on its wheels on level ground at the height 0, engine stopped, heading north.
inline simulation::Aircraft standing(double heightM = 1.3)
{
    simulation::Aircraft aircraft(lightSingle(), earthHere());
    simulation::FlightState state = aircraft.flightState();
    state.motion.position = {0.0, 0.0, heightM};
    state.motion.attitude =
        simulation::levelAttitude(aircraft.earth().placeAt(state.motion.position), 0.0, 0.0, 0.0);
    aircraft.place(state);
    return aircraft;
}

} // namespace testsupport
