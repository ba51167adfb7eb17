// SPDX-License-Identifier: Apache-2.0
#include "VerticalShift.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <cpl_error.h>

namespace osgTerrainROAM::core
{

namespace
{

/// A transformation that PROJ makes only where it has what it takes: without leave for one by the ballpark it
/// says so instead of returning heights as they were.
CoordinateTransform exactTransform(OGRSpatialReferenceH from, OGRSpatialReferenceH to)
{
    const OGRCoordinateTransformationOptionsH options = OCTNewCoordinateTransformationOptions();
    OCTCoordinateTransformationOptionsSetBallparkAllowed(options, FALSE);
    CoordinateTransform made(OCTNewCoordinateTransformationEx(from, to, options));
    OCTDestroyCoordinateTransformationOptions(options);
    return made;
}

} // namespace

std::optional<VerticalShift> VerticalShift::find(OGRSpatialReferenceH compound,
                                                 std::span<const glm::dvec2> places)
{
    CPLPushErrorHandler(CPLQuietErrorHandler);
    const ReferenceSystem from(OSRClone(compound)), to(OSRNewSpatialReference(nullptr));
    OSRImportFromEPSG(to.get(), 4979); // WGS84 with ellipsoidal heights
    for (const OGRSpatialReferenceH system : {from.get(), to.get()})
        OSRSetAxisMappingStrategy(system, OAMS_TRADITIONAL_GIS_ORDER);
    VerticalShift shift;
    shift._toEllipsoid = exactTransform(from.get(), to.get());
    std::vector<double> heightsM(places.size(), std::numeric_limits<double>::quiet_NaN());
    if (shift._toEllipsoid) shift.heights(places, heightsM);
    CPLPopErrorHandler();
    if (std::all_of(heightsM.begin(), heightsM.end(), [](double height) { return std::isfinite(height); }))
        return shift;
    return std::nullopt;
}

void VerticalShift::heights(std::span<const glm::dvec2> places, std::span<double> heightsM) const
{
    std::vector<double> x, y, z(places.size(), 0.0);
    for (const glm::dvec2& place : places)
    {
        x.push_back(place.x);
        y.push_back(place.y);
    }
    std::vector<int> good(places.size(), FALSE);
    CPLPushErrorHandler(CPLQuietErrorHandler);
    OCTTransformEx(_toEllipsoid.get(), static_cast<int>(places.size()), x.data(), y.data(), z.data(),
                   good.data());
    CPLPopErrorHandler();
    for (std::size_t i = 0; i < places.size(); ++i)
        if (good[i] && std::isfinite(z[i])) heightsM[i] = z[i];
}

} // namespace osgTerrainROAM::core
