// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <foundation/DataFile.h>
#include <glm/vec2.hpp>

#include "RideRequest.h"

namespace trainer
{

/// The arguments of `trainer fly`; the terrain file is the world, none is level ground. Empty paths: none.
struct FlyRequest : RideRequest
{
    std::filesystem::path aircraft = foundation::dataFile(
        "aircraft/c172p.xml");        ///< a data file; with jsbsimRoot also the name of an aircraft of JSBSim
    std::filesystem::path jsbsimRoot; ///< the folder with JSBSim's aircraft/; empty: that of the data file
    std::filesystem::path jsbsim;     ///< JSBSim's program; empty: that of the data file, or of PATH
    std::string
        orders; ///< of the autopilot; empty: takeoff, circuit, land with a strip, else it holds what it has
    /// east, north, height above the ground, heading in degrees, speed in m/s; empty: on the strip, or over
    /// the middle
    std::vector<double> start;
    std::vector<double> wind; ///< from, degrees; kt; empty: that of the weather report, where there is one
    double gustsMps = 0.0;    ///< deviation of turbulence above 600 m
    std::uint64_t seed = 1;   ///< of the turbulence

    /// The velocity of the air, east and north in m/s; zero without a wind.
    glm::dvec2 windMps() const;

    /// Flies in the wind that the weather of `play` tells, unless one was asked for.
    void takeReportedWind();
};

} // namespace trainer
