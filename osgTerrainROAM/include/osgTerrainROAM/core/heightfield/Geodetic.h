// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace osgTerrainROAM::core
{

/// A position on WGS84. Units: degrees, metres above the ellipsoid.
struct Geodetic
{
    double latitudeDeg = 0.0;
    double longitudeDeg = 0.0;
    double heightM = 0.0;
};

} // namespace osgTerrainROAM::core
