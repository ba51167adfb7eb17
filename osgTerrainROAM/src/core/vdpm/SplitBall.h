// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <osgTerrainROAM/core/roam/RoamTile.h>
#include <osgTerrainROAM/core/vdpm/VertexForest.h>

namespace osgTerrainROAM::core
{

/// Returns the bound of a split of which the faces that it changes are off by `error`: the ball contains
/// these faces and all points within `error` of them, and all is rounded up. `star`: the faces around v0,
/// which cover the same area.
inline SplitBound ballAround(std::span<const Triangle> star, const std::vector<glm::dvec3>& positions,
                             double error)
{
    constexpr double kNothing = 1e-9, kRounding = 1.0 + 1e-7;
    constexpr float kFar = std::numeric_limits<float>::max();
    glm::dvec3 low = positions[star[0][0]], high = low;
    for (const Triangle& t : star)
        for (const std::uint32_t v : t)
        {
            low = glm::min(low, positions[v]);
            high = glm::max(high, positions[v]);
        }
    SplitBound bound;
    bound.centre = glm::vec3((low + high) * 0.5);
    double radius = 0.0;
    for (const Triangle& t : star)
        for (const std::uint32_t v : t)
            radius = std::max(radius, glm::distance(glm::dvec3(bound.centre), positions[v]));
    bound.errorM = error < kNothing ? 0.0f : std::nextafter(static_cast<float>(error * kRounding), kFar);
    bound.radiusM = std::nextafter(static_cast<float>((radius + error) * kRounding), kFar);
    return bound;
}

} // namespace osgTerrainROAM::core
