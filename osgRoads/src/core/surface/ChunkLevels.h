// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <glm/geometric.hpp>

#include <viewlod/ScreenError.h>
#include <viewlod/ViewState.h>

#include <osgRoads/core/surface/RoadMesh.h>

namespace osgRoads::core
{

/// Whether a sphere comes nearer to the eye than `farthestM`.
inline bool isNear(const viewlod::ViewState& view, const glm::dvec3& centre, double radius, double farthestM)
{
    return glm::distance(view.eyeWorld, centre) - radius <= farthestM;
}

/// Returns the coarsest level of a chunk whose error stays within the tolerance anywhere in the image; else the finest.
inline std::uint32_t coarsestLevel(const RoadChunk& chunk, const viewlod::ViewState& view, double tolerancePx)
{
    const double pixels = view.guaranteedPixelsPerTangent();
    const double distance = glm::distance(view.eyeWorld, chunk.centre);
    std::size_t level = chunk.levels.size() - 1;
    while (level > 0 && viewlod::screenErrorBoundPx(pixels, chunk.levels[level].errorM, distance,
                                                    chunk.radius, view.nearM) > tolerancePx)
        --level;
    return static_cast<std::uint32_t>(level);
}

} // namespace osgRoads::core
