// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "simulation/scenario/Position.h"

namespace simulation
{

/// A vertex of a polyline, placed in the scene.
struct PathVertex
{
    double parameter = 0.0; ///< time in seconds, or distance along the chords in metres
    glm::dvec3 position{0.0};
    Orientation orientation;
};

} // namespace simulation
