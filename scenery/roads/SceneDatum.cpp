// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/SceneDatum.h"

namespace scenery
{

glm::dvec3 SceneDatum::toScene(const osgRoads::core::RoadPosition& position, const glm::dvec3& inertial) const
{
    const double base = _base ? _base->heightM(position, inertial) : 0.0;
    return _map.toScene({inertial.x, inertial.y, inertial.z + base});
}

glm::dvec3 SceneDatum::toInertial(const glm::dvec3& scene) const
{
    glm::dvec3 plan = _map.toPlan(scene);
    if (_base) plan.z -= _base->ground().heightM(plan);
    return plan;
}

} // namespace scenery
