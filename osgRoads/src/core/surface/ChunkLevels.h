// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <glm/geometric.hpp>

#include <viewlod/ScreenError.h>
#include <viewlod/ViewState.h>

#include <osgRoads/core/surface/RoadMesh.h>
#include <osgRoads/core/surface/RoadView.h>

namespace osgRoads::core
{

/// Whether a sphere comes nearer to the eye than `farthestM`.
inline bool isNear(const viewlod::ViewState& view, const glm::dvec3& centre, double radius, double farthestM)
{
    return glm::distance(view.eyeWorld, centre) - radius <= farthestM;
}

/// Returns the coarsest level of a chunk whose error stays within the tolerances (RoadViewSettings); else the
/// finest.
inline std::uint32_t coarsestLevel(const RoadChunk& chunk, const viewlod::ViewState& view,
                                   const RoadViewSettings& settings)
{
    const double pixels = view.guaranteedPixelsPerTangent();
    const double distance = glm::distance(view.eyeWorld, chunk.centre);
    const bool isWhereWheelsAreSeen = distance - chunk.radius < settings.liftFromM;
    const auto isTooCoarse = [&](double errorM)
    {
        if (isWhereWheelsAreSeen && errorM > settings.nearErrorM) return true;
        return viewlod::screenErrorBoundPx(pixels, errorM, distance, chunk.radius, view.nearM) >
               settings.tolerancePx;
    };
    std::size_t level = chunk.levels.size() - 1;
    while (level > 0 && isTooCoarse(chunk.levels[level].errorM))
        --level;
    return static_cast<std::uint32_t>(level);
}

} // namespace osgRoads::core
