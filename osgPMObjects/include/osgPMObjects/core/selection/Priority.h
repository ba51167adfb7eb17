// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>
#include <glm/vec3.hpp>

#include <osgPMObjects/core/selection/BoundingVolumes.h>

namespace osgPMObjects::core
{

/// The worth of an object for the exercise.
struct Priority
{
    double importance = 1.0; ///< above 0; 1 is the normal importance
    bool isAttended =
        false; ///< whether the trainee deals with it now: the target in the sight, the vehicle ahead
};

/// The rule that turns attention into a gain of detail. Attended objects have the gain `attendedGain`. For
/// the others, if `gazeInnerDeg` < 180, the gain falls linearly with the angle from the gaze: from 1 at
/// `gazeInnerDeg` to `peripheralGain` at `gazeOuterDeg`. Invariant: checkSettings().
struct AttentionRule
{
    double attendedGain = 2.0;   ///< at least 1
    double peripheralGain = 0.5; ///< above 0, at most 1
    double gazeInnerDeg = 180.0,
           gazeOuterDeg = 180.0;     ///< 0 ≤ inner ≤ outer ≤ 180; 180: the gaze is not known
    glm::dvec3 gaze{0.0, 0.0, -1.0}; ///< direction of the gaze; unit length; frame: world
};

/// Tells whether a rule is complete and in its ranges: else an error that names the field. priorityGain()
/// does not check.
foundation::Outcome checkSettings(const AttentionRule& rule);
foundation::Outcome checkSettings(const Priority& priority);

/// Computes the factor by which an object counts as larger than it is seen: importance times attention. All
/// methods use it in one way, as if a magnifying device were held before this object alone: distances
/// (ranges, the continuous rule) and tolerances in pixels are divided by it, areas and the benefit in a
/// budget are multiplied by its square. An object of importance 2 is drawn as a normal one at half its
/// distance.
/// Source: Sadykov & Zakharov, *Choosing the level of detail in continuous simplification of polygonal
/// objects* (2002), section 2.3.4, names the principle (King 2000). Differs: the formula.
double priorityGain(const Priority& priority, const AttentionRule& rule, const glm::dvec3& eyeWorld,
                    const BoundingSphere& sphere);

} // namespace osgPMObjects::core
