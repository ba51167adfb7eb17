// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>

#include <osgTerrainROAM/core/heightfield/Geodetic.h>

namespace osgTerrainROAM::core
{

/// The local east-north-up frame about a position on WGS84.
inline GeographicLib::LocalCartesian localFrameAt(const Geodetic& origin)
{
    return {origin.latitudeDeg, origin.longitudeDeg, origin.heightM, GeographicLib::Geocentric::WGS84()};
}

} // namespace osgTerrainROAM::core
