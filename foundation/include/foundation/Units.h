// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace foundation
{

/// Factors of the units that instruments have.
inline constexpr double kMpsPerKnot = 1852.0 / 3600.0, kMetresPerFoot = 0.3048, kKmhPerMps = 3.6,
                        kMpsPerMph = 0.44704;

/// 0 °C. Units: K.
inline constexpr double kZeroCelsiusK = 273.15;

} // namespace foundation
