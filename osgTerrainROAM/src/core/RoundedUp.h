// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

namespace osgTerrainROAM::core
{

/// The least float that is not below a value: a bound stays a bound.
inline float roundedUp(double value)
{
    const auto rounded = static_cast<float>(value);
    return rounded < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

} // namespace osgTerrainROAM::core
