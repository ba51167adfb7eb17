// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>

namespace osgTerrainROAM::core
{

/// The least float that is not less than `value`: bounds must not shrink by rounding.
inline float floatNotLess(double value)
{
    const float rounded = static_cast<float>(value);
    return rounded < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity()) : rounded;
}

} // namespace osgTerrainROAM::core
