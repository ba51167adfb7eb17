// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace simulation
{

/// A star as a catalogue has it. Frame: equator and equinox of J2000. Units: degrees, magnitudes.
struct BrightStar
{
    double rightAscensionDeg = 0.0, declinationDeg = 0.0;
    double magnitude = 0.0;   ///< V; smaller is brighter
    double colourIndex = 0.0; ///< B-V: -0.3 blue, 0 white, 1.5 orange
};

/// Returns the 890 stars down to magnitude 4.5, the brightest first. Positions are right within 0.01 degrees
/// at 2000; their own motion is left out.
std::vector<BrightStar> brightStars();

} // namespace simulation
