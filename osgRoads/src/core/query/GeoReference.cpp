// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 8.5 (georeferencing).
#include <cmath>
#include <utility>

#include <cpl_error.h>
#include <ogr_spatialref.h>

#include <osgRoads/core/query/GeoReference.h>

namespace osgRoads::core
{

namespace
{

/// GDAL writes to stderr unless told not to.
class QuietErrors
{
public:
    QuietErrors() { CPLPushErrorHandler(CPLQuietErrorHandler); }
    ~QuietErrors() { CPLPopErrorHandler(); }
    QuietErrors(const QuietErrors&) = delete;
    QuietErrors& operator=(const QuietErrors&) = delete;
};

} // namespace

struct GeoReference::Transforms
{
    struct DestroyTransformation
    {
        void operator()(OGRCoordinateTransformation* transformation) const
        {
            OGRCoordinateTransformation::DestroyCT(transformation);
        }
    };
    using Transformation = std::unique_ptr<OGRCoordinateTransformation, DestroyTransformation>;

    std::string file;
    glm::dvec3 offset{0.0, 0.0, 0.0};
    double cosHeading = 1.0, sinHeading = 0.0;
    Transformation toDegrees, toPlane;
};

GeoReference::GeoReference(std::unique_ptr<Transforms> transforms) : _transforms(std::move(transforms)) {}
GeoReference::~GeoReference() = default;
GeoReference::GeoReference(GeoReference&&) noexcept = default;
GeoReference& GeoReference::operator=(GeoReference&&) noexcept = default;

foundation::Result<GeoReference> GeoReference::create(const NetworkHeader& header, const std::string& file,
                                                      bool isOffsetReversed)
{
    if (header.geoReference.empty())
        return foundation::Error{file, "the header has no geoReference", "add one, or work in local metres"};
    const QuietErrors quiet;
    OGRSpatialReference plane, degrees;
    if (plane.SetFromUserInput(header.geoReference.c_str(),
                               OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) != OGRERR_NONE ||
        degrees.SetWellKnownGeogCS("WGS84") != OGRERR_NONE)
        return foundation::Error{
            file, "PROJ does not know the geoReference \"" + header.geoReference.substr(0, 80) + "\"",
            "write a PROJ string or EPSG:code"};
    plane.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    auto transforms = std::make_unique<Transforms>();
    transforms->file = file;
    transforms->toDegrees.reset(OGRCreateCoordinateTransformation(&plane, &degrees));
    transforms->toPlane.reset(OGRCreateCoordinateTransformation(&degrees, &plane));
    if (!transforms->toDegrees || !transforms->toPlane)
        return foundation::Error{file, "PROJ has no way from the geoReference to WGS84",
                                 "check the geoReference"};
    const double sign = isOffsetReversed ? -1.0 : 1.0;
    transforms->offset = sign * glm::dvec3(header.offsetX, header.offsetY, header.offsetZ);
    transforms->cosHeading = std::cos(header.offsetHeadingRad);
    transforms->sinHeading = sign * std::sin(header.offsetHeadingRad);
    return GeoReference(std::move(transforms));
}

foundation::Result<GeodeticPosition> GeoReference::toGeodetic(const glm::dvec3& inertial) const
{
    const Transforms& by = *_transforms;
    double x = inertial.x * by.cosHeading - inertial.y * by.sinHeading + by.offset.x;
    double y = inertial.x * by.sinHeading + inertial.y * by.cosHeading + by.offset.y;
    const QuietErrors quiet;
    if (!by.toDegrees->Transform(1, &x, &y) || !std::isfinite(x) || !std::isfinite(y))
        return foundation::Error{by.file, "a position lies outside the area of the geoReference",
                                 "check offset and geoReference"};
    return GeodeticPosition{y, x, inertial.z + by.offset.z};
}

foundation::Result<glm::dvec3> GeoReference::toInertial(const GeodeticPosition& geodetic) const
{
    const Transforms& by = *_transforms;
    double x = geodetic.longitudeDeg, y = geodetic.latitudeDeg;
    const QuietErrors quiet;
    if (!by.toPlane->Transform(1, &x, &y) || !std::isfinite(x) || !std::isfinite(y))
        return foundation::Error{by.file, "a position lies outside the area of the geoReference",
                                 "check the position"};
    x -= by.offset.x;
    y -= by.offset.y;
    return glm::dvec3(x * by.cosHeading + y * by.sinHeading, y * by.cosHeading - x * by.sinHeading,
                      geodetic.heightM - by.offset.z);
}

} // namespace osgRoads::core
