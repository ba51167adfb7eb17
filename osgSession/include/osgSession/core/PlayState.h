// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <glm/vec3.hpp>

namespace osgSession::core
{

/// The motion of an entity at one instant.
/// Frame: the scene's east-north-up; the position is that of the reference point, for a vehicle the middle of
/// the rear axle, on the ground. Angles as in ISO 8855: heading counter-clockwise from east, pitch positive
/// nose down, roll positive right side down, applied in this order. Units: metres, degrees, m/s.
struct Entity
{
    std::string name;
    glm::dvec3 position{0.0};
    double headingDeg = 0.0, pitchDeg = 0.0, rollDeg = 0.0;
    glm::dvec3 velocity{0.0};
    double speedMps = 0.0; ///< along the heading; negative: backwards
    bool isOnGround = false;
    bool isPresent = true; ///< false before it is added by an action and after it is deleted
};

/// Something that happened while a scenario was played.
struct Event
{
    double timeS = 0.0;
    std::string element;    ///< of the storyboard: names from the story down, `::` between them
    std::string transition; ///< in the standard's words: startTransition, endTransition …
};

} // namespace osgSession::core
