// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace simulation
{

/// What tyres roll on, as the ear tells it.
enum class TyreSound
{
    none, ///< in the air, or standing
    hard, ///< asphalt
    wet,
    loose, ///< gravel
    soft,  ///< grass, snow
};

/// Another vehicle that is heard. Units: metres, m/s.
struct PassingSound
{
    std::uint64_t id = 0;     ///< the same in each state
    double distanceM = 1e6;   ///< to its middle
    double recedingMps = 0.0; ///< how fast the distance grows
    double leftShare = 0.0;   ///< of its direction: 1 on the left, -1 on the right
    double engineHz = 80.0;   ///< of its firing
    double loudness = 1.0;    ///< 1: a car
};

/// What somebody hears in a vehicle at one instant. Shares from 0 to 1.
struct SoundState
{
    double engineHz = 0.0;    ///< firing frequency; 0: it stands
    double engineLoad = 0.0;  ///< share of full power
    double propellerHz = 0.0; ///< passages of blades; 0: none
    double airspeedMps = 0.0;
    double rollingMps = 0.0;
    TyreSound tyres = TyreSound::none;
    double tyreSlip = 0.0; ///< over that at which friction peaks
    double stallHorn = 0.0;
    double bumpMps = 0.0;        ///< of gear or body against the ground, in this instant
    bool isIndicatorLit = false; ///< a relay clicks at each change
    std::vector<PassingSound> passing{};
};

/// Firing frequency of a four-stroke engine. Units: 1/min, Hz.
constexpr double firingHz(double rpm, int cylinders)
{
    return rpm / 60.0 * cylinders / 2.0;
}

} // namespace simulation
