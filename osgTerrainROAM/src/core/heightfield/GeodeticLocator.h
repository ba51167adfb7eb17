// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include <foundation/Result.h>
#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "RasterFile.h"
#include "ReferenceSystem.h"

namespace osgTerrainROAM::core
{

/// Where on the Earth the samples of a raster are: its grid, its coordinate reference system (any that PROJ
/// knows) and what its heights are counted from. Heights above mean sea level get the EGM96 undulation, whose
/// grid comes with PROJ; one that counts from another geoid is taken for EGM96 too, for they differ by a
/// metre or two. Ellipsoidal are those whose reference system has three dimensions or names the ellipsoid as
/// its vertical datum.
/// Threads: one at a time.
class GeodeticLocator
{
public:
    /// Errors: a reference system that PROJ cannot relate to WGS84, EGM96 wanted and its grid missing.
    static foundation::Result<GeodeticLocator> create(const std::string& name, const Raster& raster,
                                                      VerticalDatum datum, GdalSession& gdal);

    /// WGS84 positions of (fractional) grid places, row 0 the southernmost. Places where the map projection
    /// is not defined get NaN.
    void locate(std::span<const glm::dvec2> grid, std::span<GeodeticNet::Node> nodes) const;

    /// Whether heights count from the ellipsoid.
    bool isEllipsoidal() const { return !_geoid; }

private:
    GeodeticLocator() = default;
    void addGeoid(std::span<GeodeticNet::Node> nodes) const;

    GridFrame _frame{};
    bool _inDegrees = false; ///< then latitudes past a pole continue down the other side
    CoordinateTransform _toWgs84;
    CoordinateTransform _geoid; ///< null: heights are ellipsoidal
};

} // namespace osgTerrainROAM::core
