// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include <foundation/Geoid.h>
#include <foundation/Result.h>
#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "RasterFile.h"
#include "ReferenceSystem.h"
#include "VerticalShift.h"

namespace osgTerrainROAM::core
{

/// Locates the samples of a raster on the Earth, from its grid, its coordinate reference system (any that
/// PROJ knows) and its vertical datum. Heights above mean sea level get the EGM96 undulation, whose grid
/// comes with PROJ; those above another datum (NAVD88, EGM2008) that of PROJ's own grid, or where it has none
/// that of EGM96, from which they differ by a metre or two: a note says so. Heights are ellipsoidal when the
/// reference system has three dimensions or names the ellipsoid as its vertical datum.
/// Threads: one at a time.
class GeodeticLocator
{
public:
    /// Errors: a reference system that PROJ cannot relate to WGS84, EGM96 wanted and its grid missing.
    static foundation::Result<GeodeticLocator> create(const std::string& name, const Raster& raster,
                                                      VerticalDatum datum, GdalSession& gdal);

    /// WGS84 positions of (fractional) grid coordinates, row 0 the southernmost; NaN where the map projection
    /// is not defined.
    void locate(std::span<const glm::dvec2> grid, std::span<GeodeticNet::Node> nodes) const;

    /// Tells whether heights are above the ellipsoid.
    bool isEllipsoidal() const { return !_geoid; }

    /// The vertical reference system that the raster names, as "NAVD88 height"; empty: none, or the
    /// ellipsoid.
    const std::string& verticalName() const { return _vertical; }

private:
    GeodeticLocator() = default;
    void addGeoid(std::span<const glm::dvec2> places, std::span<GeodeticNet::Node> nodes) const;

    GridFrame _frame{};
    bool _inDegrees = false; ///< then latitudes beyond a pole continue on the opposite meridian
    CoordinateTransform _toWgs84;
    std::optional<foundation::Geoid> _geoid; ///< absent: heights are ellipsoidal
    std::optional<VerticalShift> _shift;     ///< of a datum other than EGM96, where PROJ has its grid
    std::string _vertical;
};

} // namespace osgTerrainROAM::core
