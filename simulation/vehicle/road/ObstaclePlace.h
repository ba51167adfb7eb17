// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <btBulletDynamicsCommon.h>

#include "simulation/contact/Obstacle.h"

namespace simulation
{

/// Half the sides of the upright box of an obstacle, in its own frame. Units: metres.
inline btVector3 obstacleHalf(const Obstacle& obstacle)
{
    return {obstacle.halfM.x, obstacle.halfM.y, 0.5 * (obstacle.highM - obstacle.lowM)};
}

/// Where the middle of an obstacle is, and how it is turned. Frame: that of the obstacle's map.
inline btTransform obstaclePlace(const Obstacle& obstacle)
{
    return btTransform(
        btQuaternion(btVector3(0.0, 0.0, 1.0), std::atan2(obstacle.along.y, obstacle.along.x)),
        btVector3(obstacle.middle.x, obstacle.middle.y, 0.5 * (obstacle.lowM + obstacle.highM)));
}

} // namespace simulation
