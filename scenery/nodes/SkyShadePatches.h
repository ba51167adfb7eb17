// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <foundation/Heights.h>
#include <glm/glm.hpp>

#include "scenery/placement/SkyOccluders.h"

namespace scenery
{

/// A patch of ground that sees less of the sky. Frame: the scene's; metres.
struct SkyShadePatch
{
    struct Corner
    {
        glm::dvec3 place;
        float hidden; ///< share of the sky's light
    };
    std::vector<Corner> corners;
    std::vector<std::uint32_t> triangles; ///< three numbers of corners each
};

/// Lays a patch below a body, or before a wall, on the ground. Where the ground is not known the patch is
/// empty. Cost: a question to the ground for each corner, 85 below a body and some 30 before a wall.
SkyShadePatch patchBelow(const SkyOccluder& occluder, const foundation::HeightInPlan& ground);
SkyShadePatch patchBefore(const SkyWall& wall, const foundation::HeightInPlan& ground);

} // namespace scenery
