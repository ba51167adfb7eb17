// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/SceneFrame.h"

#include <cassert>
#include <cmath>
#include <utility>

namespace simulation
{
namespace
{

constexpr int kPlaceRounds = 3;
constexpr double kLargestCoordinate = 1e9;
constexpr double kFarthestGroundM = 1e8;

} // namespace

SceneFrame::SceneFrame(const std::optional<Geodetic>& origin, GroundProvider ground, MapProjection projection)
    : _projection(std::move(projection)), _ground(std::move(ground))
{
    if (origin) _frame.emplace(*origin);
}

bool SceneFrame::canPlace(const Position& position) const
{
    const auto isSane = [](double value) { return std::fabs(value) <= kLargestCoordinate; };
    if (const auto* geo = std::get_if<GeoPosition>(&position))
        return (_frame || onMap(*geo)) && isSane(geo->latitudeDeg) && isSane(geo->longitudeDeg) &&
               isSane(geo->heightM.value_or(0.0)) && isSane(geo->altitudeM.value_or(0.0));
    const auto* world = std::get_if<WorldPosition>(&position);
    return world && isSane(world->xM) && isSane(world->yM) && isSane(world->zM.value_or(0.0));
}

glm::dvec3 SceneFrame::place(const Position& position) const
{
    assert(canPlace(position));
    if (const auto* geo = std::get_if<GeoPosition>(&position)) return place(*geo);
    if (const auto* world = std::get_if<WorldPosition>(&position)) return place(*world);
    return glm::dvec3(0.0);
}

glm::dvec3 SceneFrame::place(const WorldPosition& position) const
{
    glm::dvec3 local(position.xM, position.yM, position.zM.value_or(0.0));
    if (!position.zM)
        if (const std::optional<GroundSample> ground = groundAt(local.x, local.y)) local.z = ground->heightM;
    return local;
}

/// The heights of a map count as those of the place.
std::optional<glm::dvec3> SceneFrame::onMap(const GeoPosition& position) const
{
    if (!_projection) return std::nullopt;
    auto local = _projection({position.latitudeDeg, position.longitudeDeg, position.heightM.value_or(0.0)});
    if (!local || position.heightM) return local;
    const std::optional<GroundSample> ground = groundAt(local->x, local->y);
    local->z = position.altitudeM.value_or(0.0) + (ground ? ground->heightM : 0.0);
    return local;
}

glm::dvec3 SceneFrame::place(const GeoPosition& position) const
{
    if (!_frame) return onMap(position).value_or(glm::dvec3(0.0));
    if (position.heightM)
        return _frame->localFromGeodetic({position.latitudeDeg, position.longitudeDeg, *position.heightM});
    // Far from the origin the place's vertical leans against the scene's: the height found there moves the
    // place.
    const double altitude = position.altitudeM.value_or(0.0);
    double height = altitude;
    glm::dvec3 local(0.0);
    for (int round = 0; round < kPlaceRounds; ++round)
    {
        local = _frame->localFromGeodetic({position.latitudeDeg, position.longitudeDeg, height});
        const std::optional<GroundSample> ground = groundAt(local.x, local.y);
        if (!ground)
            return _frame->localFromGeodetic({position.latitudeDeg, position.longitudeDeg, altitude});
        height += ground->heightM + altitude - local.z;
        local.z = ground->heightM + altitude;
    }
    return local;
}

std::optional<GroundSample> SceneFrame::groundAt(double eastM, double northM, double fromM) const
{
    const bool isNear = std::fabs(eastM) <= kFarthestGroundM && std::fabs(northM) <= kFarthestGroundM;
    return _ground && isNear ? _ground(eastM, northM, fromM) : std::nullopt;
}

Orientation orientationOf(const Position& position)
{
    if (const auto* geo = std::get_if<GeoPosition>(&position)) return geo->orientation;
    if (const auto* world = std::get_if<WorldPosition>(&position)) return world->orientation;
    return {};
}

} // namespace simulation
