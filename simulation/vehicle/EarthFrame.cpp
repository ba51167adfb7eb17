// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/EarthFrame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <GeographicLib/Geocentric.hpp>
#include <foundation/Angle.h>

namespace simulation
{

namespace
{

/// East, north and up of a place, in the Earth's frame, as columns.
glm::dmat3 axesAt(double latitudeDeg, double longitudeDeg)
{
    const double phi = foundation::radiansOf(latitudeDeg), lambda = foundation::radiansOf(longitudeDeg);
    const double sinPhi = std::sin(phi), cosPhi = std::cos(phi);
    const double sinLambda = std::sin(lambda), cosLambda = std::cos(lambda);
    return {{-sinLambda, cosLambda, 0.0},
            {-sinPhi * cosLambda, -sinPhi * sinLambda, cosPhi},
            {cosPhi * cosLambda, cosPhi * sinLambda, sinPhi}};
}

} // namespace

EarthFrame::EarthFrame(const Geodetic& origin)
    : _frame(origin),
      _sceneToEarth(axesAt(origin.latitudeDeg, origin.longitudeDeg)),
      _gravity(GeographicLib::NormalGravity::WGS84())
{
    GeographicLib::Geocentric::WGS84().Forward(origin.latitudeDeg, origin.longitudeDeg, origin.heightM,
                                               _originEarth.x, _originEarth.y, _originEarth.z);
    _earthRate = glm::transpose(_sceneToEarth) * glm::dvec3(0.0, 0.0, _gravity.AngularVelocity());
}

EarthFrame::Place EarthFrame::placeAt(const glm::dvec3& position) const
{
    const Geodetic geodetic = _frame.geodeticFromLocal(position);
    const glm::dmat3 axes =
        glm::transpose(_sceneToEarth) * axesAt(geodetic.latitudeDeg, geodetic.longitudeDeg);
    return {geodetic, axes[2], axes[1]};
}

EarthFrame::Place EarthFrame::geocentricPlaceAt(const glm::dvec3& position) const
{
    Place place = placeAt(position);
    const glm::dvec3 east = glm::cross(place.north, place.up);
    place.up = glm::normalize(position + glm::transpose(_sceneToEarth) * _originEarth);
    place.north = glm::cross(place.up, east);
    return place;
}

glm::dvec3 EarthFrame::gravityAt(const glm::dvec3& position) const
{
    const glm::dvec3 earth = _originEarth + _sceneToEarth * position;
    glm::dvec3 gravity;
    _gravity.U(earth.x, earth.y, earth.z, gravity.x, gravity.y, gravity.z);
    return glm::transpose(_sceneToEarth) * gravity;
}

LevelAngles levelAngles(const EarthFrame::Place& place, const glm::dquat& attitude)
{
    const glm::dvec3 nose = attitude * glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 right = attitude * glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 belly = attitude * glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 east = glm::cross(place.north, place.up);
    const double heading = std::atan2(glm::dot(nose, east), glm::dot(nose, place.north));
    return {heading < 0.0 ? heading + 2.0 * std::numbers::pi : heading,
            std::asin(std::clamp(glm::dot(nose, place.up), -1.0, 1.0)),
            std::atan2(-glm::dot(right, place.up), -glm::dot(belly, place.up))};
}

glm::dquat levelAttitude(const EarthFrame::Place& place, double heading, double pitch, double roll)
{
    const glm::dvec3 east = glm::cross(place.north, place.up);
    const glm::dquat level = glm::quat_cast(glm::dmat3(place.north, east, -place.up));
    return level * glm::angleAxis(heading, glm::dvec3(0.0, 0.0, 1.0)) *
           glm::angleAxis(pitch, glm::dvec3(0.0, 1.0, 0.0)) * glm::angleAxis(roll, glm::dvec3(1.0, 0.0, 0.0));
}

} // namespace simulation
