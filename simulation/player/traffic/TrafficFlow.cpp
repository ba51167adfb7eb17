// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/traffic/TrafficFlow.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "simulation/player/controllers/SpeedController.h"
#include "simulation/road/SpeedLimit.h"

namespace simulation
{
namespace
{

constexpr double kDefaultMps = 50.0 / 3.6;
constexpr double kRoomM = 8.0;
constexpr double kBesideM = 2.5;
constexpr double kStoreysM = 4.0; ///< on another level, as on a bridge

const ScenarioObject& objectOf(TrafficScene& scene, int entity)
{
    return scene.scenario().entities[static_cast<std::size_t>(entity)];
}

/// The middle of an entity's box.
glm::dvec3 middleOf(TrafficScene& scene, int entity)
{
    const EntityState& state = scene.motion(entity).state();
    return state.position + state.bodyToLocal() * objectOf(scene, entity).box().centre;
}

} // namespace

double defaultSpeed(TrafficScene& scene, int vehicle, const RoadPlace& place)
{
    const double wanted = speedLimitAt(*scene.roads(), place).value_or(kDefaultMps);
    const double most = performanceOf(objectOf(scene, vehicle)).maxSpeedMps;
    return most > 0.0 ? std::min(wanted, most) : wanted;
}

bool hasRoom(TrafficScene& scene, int vehicle, const LaneSite& site)
{
    const BoundingBox& own = objectOf(scene, vehicle).box();
    const glm::dvec2 ahead(std::cos(site.headingRad), std::sin(site.headingRad));
    const glm::dvec2 middle = glm::dvec2(site.position) + ahead * own.centre.x;
    for (int i = 0; i < static_cast<int>(scene.scenario().entities.size()); ++i)
    {
        if (i == vehicle || !scene.isPresent(i)) continue;
        const glm::dvec3 other = middleOf(scene, i);
        const glm::dvec2 apart = glm::dvec2(other) - middle;
        const double along = std::fabs(glm::dot(apart, ahead));
        const double beside = std::fabs(ahead.x * apart.y - ahead.y * apart.x);
        const double length = 0.5 * (own.lengthM + objectOf(scene, i).box().lengthM);
        if (along < length + kRoomM && beside < kBesideM && std::fabs(other.z - site.position.z) < kStoreysM)
            return false;
    }
    return true;
}

int absentOf(TrafficScene& scene, const std::vector<int>& vehicles)
{
    const auto found = std::find_if(vehicles.begin(), vehicles.end(),
                                    [&](int vehicle) { return !scene.isPresent(vehicle); });
    return found == vehicles.end() ? -1 : *found;
}

const LaneSite* pickSite(TrafficScene& scene, int vehicle, const std::vector<const LaneSite*>& sites,
                         RandomDraw& draw)
{
    constexpr int kAttempts = 30;
    for (int attempt = 0; attempt < kAttempts && !sites.empty(); ++attempt)
    {
        const double at = draw.uniform(0.0, static_cast<double>(sites.size()));
        const LaneSite* const site = sites[std::min(static_cast<std::size_t>(at), sites.size() - 1)];
        if (hasRoom(scene, vehicle, *site)) return site;
    }
    return nullptr;
}

} // namespace simulation
