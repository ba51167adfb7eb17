// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <foundation/SettingsCheck.h>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include <osgPMObjects/core/selection/Priority.h>

namespace osgPMObjects::core
{

foundation::Outcome checkSettings(const AttentionRule& rule)
{
    constexpr double kUnitSlack = 1e-3;
    return foundation::SettingsCheck("attention")
        .within("attendedGain", rule.attendedGain, 1.0)
        .above("peripheralGain", rule.peripheralGain, 0.0, 1.0)
        .within("gazeInnerDeg", rule.gazeInnerDeg, 0.0, 180.0)
        .within("gazeOuterDeg", rule.gazeOuterDeg, rule.gazeInnerDeg, 180.0)
        .require(std::abs(glm::length(rule.gaze) - 1.0) < kUnitSlack, "gaze", "is not of unit length",
                 "normalise the direction")
        .outcome();
}

foundation::Outcome checkSettings(const Priority& priority)
{
    return foundation::SettingsCheck("priority").above("importance", priority.importance, 0.0).outcome();
}

double priorityGain(const Priority& priority, const AttentionRule& rule, const glm::dvec3& eyeWorld,
                    const BoundingSphere& sphere)
{
    if (priority.isAttended) return priority.importance * rule.attendedGain;
    if (rule.gazeInnerDeg >= 180.0) return priority.importance;
    const glm::dvec3 toObject = sphere.centre - eyeWorld;
    const double distance = glm::length(toObject);
    if (distance <= sphere.radius) return priority.importance;
    // The angle to the nearest point of the sphere counts: the gaze at any part of a large object is a gaze
    // at the object.
    const double cosine = std::clamp(glm::dot(toObject, rule.gaze) / distance, -1.0, 1.0);
    const double offDeg = glm::degrees(std::acos(cosine) - std::asin(sphere.radius / distance));
    const double width = rule.gazeOuterDeg - rule.gazeInnerDeg;
    const double away =
        width > 0.0 ? (offDeg - rule.gazeInnerDeg) / width : (offDeg > rule.gazeInnerDeg ? 1.0 : 0.0);
    return priority.importance * glm::mix(1.0, rule.peripheralGain, std::clamp(away, 0.0, 1.0));
}

} // namespace osgPMObjects::core
