// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/SceneDatum.h"

#include <algorithm>
#include <cstddef>

namespace scenery
{

namespace
{

using osgRoads::core::Road;
using osgRoads::core::RoadLink;

double smoothStep(double share)
{
    const double x = std::clamp(share, 0.0, 1.0);
    return x * x * (3.0 - 2.0 * x);
}

/// 1 at an end that is a junction, 0 from kBlendM on.
double nearEnd(const std::optional<RoadLink>& link, double fromEndM)
{
    return link && link->isJunction ? smoothStep(1.0 - fromEndM / SceneDatum::kBlendM) : 0.0;
}

double junctionShare(const Road& road, double s)
{
    if (road.junction >= 0) return 1.0;
    return std::max(nearEnd(road.predecessor, s), nearEnd(road.successor, road.length - s));
}

} // namespace

double SceneDatum::baseM(const osgRoads::core::RoadPosition& position, const glm::dvec2& plan) const
{
    const Road& road = _network->roads[static_cast<std::size_t>(position.road)];
    const double share = junctionShare(road, position.s);
    const double here = share > 0.0 ? _base->heightM(plan) : 0.0;
    if (share >= 1.0) return here;
    const double below = _base->heightM(road.referenceLine.at(position.s).position);
    return below + share * (here - below);
}

glm::dvec3 SceneDatum::toScene(const osgRoads::core::RoadPosition& position, const glm::dvec3& inertial) const
{
    const double base = _base ? baseM(position, inertial) : 0.0;
    return _map.toScene({inertial.x, inertial.y, inertial.z + base});
}

glm::dvec3 SceneDatum::toInertial(const glm::dvec3& scene) const
{
    glm::dvec3 plan = _map.toPlan(scene);
    if (_base) plan.z -= _base->heightM(plan);
    return plan;
}

} // namespace scenery
