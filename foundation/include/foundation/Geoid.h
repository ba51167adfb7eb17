// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include <cpl_error.h>
#include <ogr_srs_api.h>

namespace foundation
{

/// The geoid EGM96: how high mean sea level lies above the ellipsoid WGS84, by the 15' grid that comes with
/// PROJ (Debian's proj-data), between whose nodes it is bilinear. EGM96 is accurate to half a metre; other
/// geoids differ from it by a metre or two. Whoever includes this links GDAL.
/// Threads: one at a time.
/// Source: Lemoine and others, *The development of the joint NASA GSFC and NIMA geopotential model EGM96*,
/// 1998.
class Geoid
{
public:
    /// Returns nothing where PROJ does not find the grid.
    static std::optional<Geoid> open()
    {
        CPLPushErrorHandler(CPLQuietErrorHandler);
        // A pipeline fails when the grid is missing; a transformation between named systems would not.
        const OGRCoordinateTransformationOptionsH options = OCTNewCoordinateTransformationOptions();
        OCTCoordinateTransformationOptionsSetOperation(
            options,
            "+proj=pipeline +step +proj=unitconvert +xy_in=deg +xy_out=rad"
            " +step +proj=vgridshift +grids=egm96_15.gtx +multiplier=1"
            " +step +proj=unitconvert +xy_in=rad +xy_out=deg",
            FALSE);
        Geoid geoid;
        geoid._shift.reset(OCTNewCoordinateTransformationEx(nullptr, nullptr, options));
        OCTDestroyCoordinateTransformationOptions(options);
        const bool isThere = geoid._shift && std::isfinite(geoid.heightM(0.0, 0.0));
        CPLPopErrorHandler();
        if (!isThere) return std::nullopt;
        return geoid;
    }

    /// Puts the heights of the sea above the ellipsoid at places into `heightsM`; NaN where the grid has
    /// none. Units: degrees, metres.
    void heights(std::span<const double> latitudesDeg, std::span<const double> longitudesDeg,
                 std::span<double> heightsM) const
    {
        std::vector<double> x(longitudesDeg.begin(), longitudesDeg.end()),
            y(latitudesDeg.begin(), latitudesDeg.end()), z(x.size(), 0.0);
        for (double& longitude : x)
            longitude = std::remainder(longitude, 360.0);
        std::vector<int> good(x.size(), FALSE);
        OCTTransformEx(_shift.get(), static_cast<int>(x.size()), x.data(), y.data(), z.data(), good.data());
        for (std::size_t i = 0; i < x.size(); ++i)
            heightsM[i] = good[i] && std::isfinite(z[i]) ? z[i] : std::nan("");
    }

    double heightM(double latitudeDeg, double longitudeDeg) const
    {
        double height = 0.0;
        heights({&latitudeDeg, 1}, {&longitudeDeg, 1}, {&height, 1});
        return height;
    }

private:
    struct Closer
    {
        void operator()(OGRCoordinateTransformationH shift) const
        {
            OCTDestroyCoordinateTransformation(shift);
        }
    };
    std::unique_ptr<std::remove_pointer_t<OGRCoordinateTransformationH>, Closer> _shift;
};

} // namespace foundation
