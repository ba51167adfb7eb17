// SPDX-License-Identifier: Apache-2.0
#include "FrameTransform.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace osgTerrainROAM::core
{

namespace
{

using foundation::Error;
using foundation::Result;

ReferenceSystem horizontal(const std::string& wkt)
{
    ReferenceSystem system(OSRNewSpatialReference(wkt.c_str()));
    makeHorizontal(system.get());
    return system;
}

/// Computes the whole turns, in degrees, that bring the longitudes of one grid next to the other's across the
/// date line.
double turnsBetween(OGRSpatialReferenceH crs, const GridFrame& from, const GridFrame& to)
{
    return OSRIsGeographic(crs) ? 360.0 * std::round((to.firstX - from.firstX) / 360.0) : 0.0;
}

} // namespace

Result<FrameTransform> FrameTransform::create(const std::string& name, const GridReference& from,
                                              const GridReference& to, GdalSession& gdal)
{
    FrameTransform transform;
    transform._from = from.frame;
    transform._to = to.frame;
    if (from.crsWkt.empty() != to.crsWkt.empty())
        return Error{name, "is a plane, and other rasters of the terrain lie on the Earth, or the reverse",
                     "assign its reference system with gdal_translate -a_srs"};
    if (from.crsWkt == to.crsWkt && from.crsWkt.empty()) return transform;
    const ReferenceSystem source = horizontal(from.crsWkt), target = horizontal(to.crsWkt);
    if (OSRIsSame(source.get(), target.get()))
    {
        transform._from.firstX += turnsBetween(source.get(), from.frame, to.frame);
        return transform;
    }
    gdal.clear();
    transform._crs.reset(OCTNewCoordinateTransformation(source.get(), target.get()));
    if (!transform._crs)
        return Error{
            name, "has coordinates that cannot be related to the other rasters' (" + gdal.firstError() + ")",
            "reproject it with gdalwarp -t_srs EPSG:4326"};
    return transform;
}

void FrameTransform::apply(std::span<glm::dvec2> places) const
{
    const auto first = [](const GridFrame& f) { return glm::dvec2(f.firstX, f.firstY); };
    const auto step = [](const GridFrame& f) { return glm::dvec2(f.stepX, f.stepY); };
    for (glm::dvec2& place : places)
        place = first(_from) + place * step(_from);
    if (_crs)
    {
        std::vector<double> x, y;
        for (const glm::dvec2& place : places)
        {
            x.push_back(place.x);
            y.push_back(place.y);
        }
        std::vector<int> good(places.size(), FALSE);
        OCTTransformEx(_crs.get(), static_cast<int>(places.size()), x.data(), y.data(), nullptr, good.data());
        for (std::size_t i = 0; i < places.size(); ++i)
            places[i] =
                good[i] ? glm::dvec2(x[i], y[i]) : glm::dvec2(std::numeric_limits<double>::quiet_NaN());
    }
    for (glm::dvec2& place : places)
        place = (place - first(_to)) / step(_to);
}

} // namespace osgTerrainROAM::core
