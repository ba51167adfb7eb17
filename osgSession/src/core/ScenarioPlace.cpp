// SPDX-License-Identifier: Apache-2.0
#include "ScenarioPlace.h"

#include <algorithm>

namespace trainer
{

namespace
{

std::optional<simulation::Geodetic> placeOf(const simulation::Position& position)
{
    const auto* geo = std::get_if<simulation::GeoPosition>(&position);
    if (!geo) return std::nullopt;
    return simulation::Geodetic{geo->latitudeDeg, geo->longitudeDeg, 0.0};
}

std::optional<simulation::Geodetic> placeOf(const simulation::PrivateAction& action)
{
    if (const auto* teleport = std::get_if<simulation::TeleportAction>(&action))
        return placeOf(teleport->position);
    const auto* follow = std::get_if<simulation::FollowTrajectoryAction>(&action);
    const auto* polyline = follow ? std::get_if<simulation::Polyline>(&follow->trajectory.shape) : nullptr;
    if (!polyline || polyline->vertices.empty()) return std::nullopt;
    return placeOf(polyline->vertices.front().position);
}

} // namespace

std::optional<simulation::Geodetic> placeOnEarth(const simulation::Scenario& scenario)
{
    for (const simulation::InitPrivate& initial : scenario.storyboard.init.privates)
        for (const simulation::PrivateAction& action : initial.actions)
            if (const auto place = placeOf(action)) return place;
    return std::nullopt;
}

std::optional<glm::dvec3> startInWorld(const simulation::Scenario& scenario)
{
    std::optional<glm::dvec3> start;
    for (const simulation::InitPrivate& initial : scenario.storyboard.init.privates)
        for (const simulation::PrivateAction& action : initial.actions)
        {
            const auto* teleport = std::get_if<simulation::TeleportAction>(&action);
            const auto* world =
                teleport ? std::get_if<simulation::WorldPosition>(&teleport->position) : nullptr;
            if (!world) continue;
            const double z = world->zM.value_or(0.0);
            if (!start) start = glm::dvec3(world->xM, world->yM, z);
            start->z = std::min(start->z, z);
        }
    return start;
}

} // namespace trainer
