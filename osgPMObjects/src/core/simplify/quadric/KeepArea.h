// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "../star/Star.h"

namespace osgPMObjects::core
{

/// Two stars that become one: the middles of both merge.
struct MergingStars
{
    const Star& from;
    const Star& to;
    std::span<const glm::dvec3> positions;
};

/// Returns the place of a merged position at which the faces around it have as much area as those of both
/// stars had, by moving `at` away from the middle of its ring; `at` itself where they have no less there, or
/// where there are none. Never farther than `most` from `at`.
glm::dvec3 placeKeepingArea(const MergingStars& stars, const glm::dvec3& at, double most);

} // namespace osgPMObjects::core
