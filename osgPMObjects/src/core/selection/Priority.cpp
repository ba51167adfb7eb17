// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include <osgPMObjects/core/selection/Priority.h>

namespace osgPMObjects::core
{

double priorityGain(const Priority& priority, const AttentionRule& rule, const glm::dvec3& eyeWorld,
                    const BoundingSphere& sphere)
{
    if (priority.isAttended) return priority.importance * rule.attendedGain;
    if (rule.gazeInnerDeg >= 180.0) return priority.importance;
    const glm::dvec3 toObject = sphere.centre - eyeWorld;
    const double distance = glm::length(toObject);
    if (distance <= sphere.radius) return priority.importance;
    // The sphere's nearest point to the gaze counts: a large object that is looked at anywhere is looked at.
    const double cosine = std::clamp(glm::dot(toObject, rule.gaze) / distance, -1.0, 1.0);
    const double offDeg = glm::degrees(std::acos(cosine) - std::asin(sphere.radius / distance));
    const double width = rule.gazeOuterDeg - rule.gazeInnerDeg;
    const double away =
        width > 0.0 ? (offDeg - rule.gazeInnerDeg) / width : (offDeg > rule.gazeInnerDeg ? 1.0 : 0.0);
    return priority.importance * glm::mix(1.0, rule.peripheralGain, std::clamp(away, 0.0, 1.0));
}

} // namespace osgPMObjects::core
