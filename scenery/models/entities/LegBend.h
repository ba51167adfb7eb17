// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat4x4.hpp>

namespace scenery::models
{

/// A leg of two bones that moves in the plane y = const. Units: metres.
struct Leg
{
    double upperM = 0.4, lowerM = 0.4;
    bool jointAhead = true; ///< a knee; false: a hock, which bends backwards
};

/// Where the bones are when the leg's end is at a target as near as the leg reaches.
struct LegBend
{
    glm::dvec3 joint{0.0}, end{0.0};       ///< knee and ankle
    double upperRad = 0.0, lowerRad = 0.0; ///< of the bones from straight down, forwards
};

/// Bends a leg by the law of cosines. `hip`, `target`: in one frame, x forward, z up; y of the hip is kept.
LegBend bendLeg(const Leg& leg, const glm::dvec3& hip, const glm::dvec3& target);

/// Returns the matrix of a bone that was made hanging down from its origin, swung forwards.
glm::dmat4 swungFrom(const glm::dvec3& origin, double forwardsRad);

} // namespace scenery::models
