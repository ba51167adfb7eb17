// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "simulation/player/actions/RunningAction.h"

namespace simulation
{

/// The box of an entity of a scene, around its reference point.
inline const BoundingBox& boxOf(const ActionScene& scene, int entity)
{
    return scene.scenario().entities[static_cast<std::size_t>(entity)].box();
}

} // namespace simulation
