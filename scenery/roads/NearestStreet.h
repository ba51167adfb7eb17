// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include <glm/glm.hpp>

#include <osgRoads/core/place/PlacedNetwork.h>

namespace scenery
{

inline constexpr double kStreetOfHouseM = 60.0; ///< a street farther away is not a house's

/// Returns a function that finds the nearest place of a street in the plan from a place on the ground, within
/// kStreetOfHouseM. The network must outlive it. Frame: the scene's.
inline std::function<std::optional<glm::dvec2>(const glm::dvec3&)>
nearestStreet(const osgRoads::core::PlacedNetwork& roads)
{
    return [&roads](const glm::dvec3& place) -> std::optional<glm::dvec2>
    {
        const auto match = roads.locator().nearest(glm::dvec2(roads.toInertial(place)), kStreetOfHouseM);
        if (!match) return std::nullopt;
        const auto& [road, s, t, h] = match->position;
        return glm::dvec2(roads.surfacePoint(road, s, t));
    };
}

} // namespace scenery
