// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "worldmaking/madeup/GroundGrid.h"
#include "worldmaking/madeup/PlanArea.h"

namespace worldmaking
{

/// What fields have to keep to.
/// Threads: what is asked for here is called in many at once.
struct ParcelRules
{
    const GroundGrid& ground;
    std::function<double(const glm::dvec2&)> wish; ///< of the land to be tilled: above 0 it is
    std::function<PlanArea(const MapBox&)> taken;  ///< what is taken within a box
    std::uint64_t seed = 1;
};

/// Parts land into fields: it is cut in two again and again, in the end along the contour lines where the
/// ground slopes, until the parts have the size of fields; their corners are rounded. Those on too steep
/// ground are left out; what is taken is cut away.
/// Invariant: no two fields overlap; none has a mean slope above kSteepestField.
std::vector<PlanRings> parcelsOn(const ParcelRules& rules);

/// Cuts a convex ring in two along a line.
std::pair<std::vector<glm::dvec2>, std::vector<glm::dvec2>>
cutRing(const std::vector<glm::dvec2>& ring, const glm::dvec2& through, const glm::dvec2& along);

inline constexpr double kSteepestField = 0.13;

} // namespace worldmaking
