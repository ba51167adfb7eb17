// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <ogr_srs_api.h>

namespace osgTerrainROAM::core
{

/// The surface from which a raster counts its heights, as its reference system says.
struct VerticalSystem
{
    std::string name;           ///< as "NAVD88 height"; empty: it names none
    std::string code;           ///< as "EPSG:5703"; empty: it has none
    bool isEllipsoidal = false; ///< three dimensions, or a vertical datum that is the ellipsoid
    bool isEgm96 = true;        ///< EGM96, a mean sea level of no name, or nothing said
    bool isDepth = false;       ///< counts downwards
    double metresPerUnit = 0.0; ///< of its axis; 0: not given
};

VerticalSystem verticalSystemOf(OGRSpatialReferenceH crs);

} // namespace osgTerrainROAM::core
