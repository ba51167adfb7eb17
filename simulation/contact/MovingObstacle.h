// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "simulation/contact/Obstacle.h"

namespace simulation
{

/// Something that moves by itself and that vehicles may hit: another entity. It goes on as before, whatever
/// hits it. Units: metres, m/s.
struct MovingObstacle
{
    Obstacle box{};           ///< where it is at the beginning of the step; its name is not used
    glm::dvec2 velocity{0.0}; ///< in the plan
    int number = 0;           ///< the same for one thing in every step
    std::string name{};       ///< for people
};

} // namespace simulation
