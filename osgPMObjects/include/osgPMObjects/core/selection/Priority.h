// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

#include <osgPMObjects/core/selection/BoundingVolumes.h>

namespace osgPMObjects::core
{

/// What an object is worth in the task of the exercise.
struct Priority
{
    double importance = 1.0; ///< above 0; 1: as any other
    bool isAttended =
        false; ///< whether the trainee has to do with it now: the target in the sight, the vehicle ahead
};

/// How attention is turned into detail. Attended objects have `attendedGain`; the others, where `gazeOuterDeg` is below
/// 180, go from 1 within `gazeInnerDeg` of where the eye looks down to `peripheralGain` from `gazeOuterDeg` on, linearly
/// in the angle.
struct AttentionRule
{
    double attendedGain = 2.0;                         ///< at least 1
    double peripheralGain = 0.5;                       ///< above 0, at most 1
    double gazeInnerDeg = 180.0, gazeOuterDeg = 180.0; ///< 180: where the eye looks is not known
    glm::dvec3 gaze{0.0, 0.0, -1.0};                   ///< of unit length, world
};

/// How much larger an object is treated than it is seen: importance times attention. One rule for all methods: *importance
/// magnifies*, as a viewing device does that is held before this object alone. Distances (ranges, the continuous rule) are
/// divided by it, tolerances in pixels, too, areas multiplied by its square, and so is the benefit in a budget. So an
/// object of importance 2 is drawn as one at half its distance would be.
/// Source: paper 004, section 2.3.4, which names the principle (King 2000); the rule is ours.
double priorityGain(const Priority& priority, const AttentionRule& rule, const glm::dvec3& eyeWorld,
                    const BoundingSphere& sphere);

} // namespace osgPMObjects::core
