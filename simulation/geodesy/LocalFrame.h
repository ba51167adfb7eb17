// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <GeographicLib/LocalCartesian.hpp>
#include <glm/glm.hpp>

namespace simulation
{

/// WGS84 position. Units: degrees, metres above the ellipsoid.
struct Geodetic
{
    double latitudeDeg = 0.0;
    double longitudeDeg = 0.0;
    double heightM = 0.0;

    bool operator==(const Geodetic&) const = default;
};

/// The local east-north-up frame of a scene about its geodetic origin.
/// Frame: right-handed; at the origin x is east, y north, z up. The Earth curves away below the plane z = 0.
/// Units: metres; degrees for geodetic positions. Threads: immutable, any.
/// Source: GeographicLib::LocalCartesian.
class LocalFrame
{
public:
    explicit LocalFrame(const Geodetic& origin);

    const Geodetic& origin() const { return _origin; }
    glm::dvec3 localFromGeodetic(const Geodetic& geodetic) const;
    Geodetic geodeticFromLocal(const glm::dvec3& local) const;

private:
    Geodetic _origin;
    GeographicLib::LocalCartesian _cartesian;
};

} // namespace simulation
