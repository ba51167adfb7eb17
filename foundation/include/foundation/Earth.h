// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace foundation
{

/// The mean radius of the Earth, metres: for what falls away beyond the horizon, not for places.
constexpr double kEarthRadiusM = 6371000.0;

/// The ellipsoid of WGS84: radius of the equator in metres, flattening, and the square of the eccentricity.
constexpr double kWgs84RadiusM = 6378137.0;
constexpr double kWgs84Flattening = 1.0 / 298.257223563;
constexpr double kWgs84Eccentricity2 = 6.69437999014e-3;

/// The standard acceleration of gravity, m/s². Source: ISO 80000-3.
constexpr double kStandardGravityMps2 = 9.80665;

} // namespace foundation
