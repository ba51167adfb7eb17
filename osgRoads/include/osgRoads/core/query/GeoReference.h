// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <foundation/Result.h>
#include <glm/vec3.hpp>

#include <osgRoads/core/network/RoadNetwork.h>

namespace osgRoads::core
{

/// A position on the WGS84 ellipsoid: degrees, metres above what the file's heights count from.
struct GeodeticPosition
{
    double latitudeDeg = 0.0, longitudeDeg = 0.0, heightM = 0.0;
};

/// The way from the inertial frame of a network to latitude and longitude, by PROJ (through GDAL), and back.
/// The offset of the header is applied first, as the standard has it: world = rotated(inertial) + offset.
/// Differs: netconvert up to SUMO 1.15 writes the offset with the other sign; `isOffsetReversed` reads such
/// files.
/// Threads: one at a time.
/// Source: ASAM OpenDRIVE 1.8, 8.5 (georeferencing).
class GeoReference
{
public:
    /// `file`: for errors. Errors: no geoReference, or one that PROJ does not know.
    static foundation::Result<GeoReference> create(const NetworkHeader& header, const std::string& file,
                                                   bool isOffsetReversed = false);
    ~GeoReference();
    GeoReference(GeoReference&&) noexcept;
    GeoReference& operator=(GeoReference&&) noexcept;

    /// Errors: outside the area of the projection.
    foundation::Result<GeodeticPosition> toGeodetic(const glm::dvec3& inertial) const;
    foundation::Result<glm::dvec3> toInertial(const GeodeticPosition& geodetic) const;

private:
    struct Transforms;

    explicit GeoReference(std::unique_ptr<Transforms> transforms);

    std::unique_ptr<Transforms> _transforms;
};

} // namespace osgRoads::core
