// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace measurement
{

/// Undoes osgSky::displayColour() for one channel of a picture, 0 … 1: returns light times exposure. A
/// channel whose square is above `most` counts as `most`: near white a level says little.
inline double exposedOf(double shown, double most = 0.998)
{
    return std::pow(-std::log(1.0 - std::min(shown * shown, most)), 1.0 / 1.125);
}

} // namespace measurement
