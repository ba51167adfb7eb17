// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "RasterFile.h"

namespace osgTerrainROAM::core
{

/// Tells whether a grid without a named reference system (ESRI ASCII grids name none) has degrees of
/// longitude and latitude. It has when all of it lies within ±360° and ±90°, a cell is at most 0.05° and, to
/// 0.5 %, a whole number of arc seconds or a whole fraction of one, and no corner is the zero point, where
/// plans of small sites begin.
bool looksLikeDegrees(const GridFrame& frame, int columns, int rows);

/// WGS84 longitude and latitude, as text for GeodeticLocator.
std::string wgs84Wkt();

/// Metres per unit of a planar reference system without a relation to the Earth: none named, or a local one.
/// Nothing for all others.
std::optional<double> metresOfPlane(const std::string& crsWkt);

} // namespace osgTerrainROAM::core
