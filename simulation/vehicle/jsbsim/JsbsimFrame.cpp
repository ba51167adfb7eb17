// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/jsbsim/JsbsimFrame.h"

#include <cmath>

#include <GeographicLib/Geocentric.hpp>
#include <foundation/Angle.h>

namespace simulation
{
namespace
{

glm::dvec3 earthPlaceOf(const JsbsimRow& row)
{
    return kJsbsimFootM *
           glm::dvec3(row[JsbsimColumn::earthX], row[JsbsimColumn::earthY], row[JsbsimColumn::earthZ]);
}

Geodetic geodeticOf(const glm::dvec3& earthPlace)
{
    Geodetic place;
    GeographicLib::Geocentric::WGS84().Reverse(earthPlace.x, earthPlace.y, earthPlace.z, place.latitudeDeg,
                                               place.longitudeDeg, place.heightM);
    return place;
}

/// East, north and up at a place of JSBSim's Earth, as columns.
glm::dmat3 levelAt(const glm::dvec3& earthPlace, bool isGeodetic)
{
    glm::dvec3 up = glm::normalize(earthPlace);
    const double longitude = std::atan2(earthPlace.y, earthPlace.x);
    if (isGeodetic)
    {
        const double latitude = foundation::radiansOf(geodeticOf(earthPlace).latitudeDeg);
        up = {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
              std::sin(latitude)};
    }
    const glm::dvec3 east(-std::sin(longitude), std::cos(longitude), 0.0);
    return {east, glm::cross(up, east), up};
}

} // namespace

bool isJsbsimGeodetic(const JsbsimRow& row)
{
    constexpr double kSameM = 1.0;
    return std::abs(geodeticOf(earthPlaceOf(row)).heightM - kJsbsimFootM * row[JsbsimColumn::height]) <
           kSameM;
}

JsbsimFrame::JsbsimFrame(const JsbsimRow& row, bool isGeodetic, const EarthFrame& earth,
                         const glm::dvec3& position)
    : _isGeodetic(isGeodetic), _startEarth(earthPlaceOf(row)), _startScene(position)
{
    const EarthFrame::Place place = earth.placeAt(position);
    const glm::dmat3 level(glm::cross(place.north, place.up), place.north, place.up);
    _toScene = level * glm::transpose(levelAt(_startEarth, isGeodetic));
}

EarthFrame::Place JsbsimFrame::levelOf(const JsbsimRow& row) const
{
    const glm::dmat3 level = _toScene * levelAt(earthPlaceOf(row), _isGeodetic);
    return {{}, level[2], level[1]};
}

glm::dvec3 JsbsimFrame::northEastDown(const JsbsimRow& row, const glm::dvec3& vector) const
{
    const EarthFrame::Place place = levelOf(row);
    return {glm::dot(vector, place.north), glm::dot(vector, glm::cross(place.north, place.up)),
            -glm::dot(vector, place.up)};
}

VehicleState JsbsimFrame::stateOf(const JsbsimRow& row) const
{
    const EarthFrame::Place place = levelOf(row);
    const glm::dvec3 east = glm::cross(place.north, place.up);
    VehicleState state;
    state.position = _startScene + _toScene * (earthPlaceOf(row) - _startEarth);
    state.velocity =
        kJsbsimFootM * (row[JsbsimColumn::velocityNorth] * place.north +
                        row[JsbsimColumn::velocityEast] * east - row[JsbsimColumn::velocityDown] * place.up);
    // Half a turn about the nose leads from forward, left, up to forward, right, down.
    state.bodyToScene =
        levelAttitude(place, row[JsbsimColumn::heading], row[JsbsimColumn::pitch], row[JsbsimColumn::roll]) *
        glm::dquat(0.0, 1.0, 0.0, 0.0);
    state.bodyRates = {row[JsbsimColumn::rateP], -row[JsbsimColumn::rateQ], -row[JsbsimColumn::rateR]};
    return state;
}

} // namespace simulation
