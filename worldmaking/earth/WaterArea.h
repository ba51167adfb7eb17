// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <foundation/Heights.h>

#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

/// An area of open water. Frame: the plane.
struct WaterArea
{
    PlanRings rings;
    std::vector<double> shoreM; ///< of the ground, the lowest first
    bool isRiver = false;
    std::uint32_t node = 0; ///< of the net of waters

    double shareM(double share) const
    {
        return shoreM[static_cast<std::size_t>(share * static_cast<double>(shoreM.size() - 1))];
    }
    bool isLevel() const { return !isRiver || shareM(0.9) - shareM(0.1) < kLevelM; }

    static constexpr double kLevelM = 2.0; ///< between high and low of the shore of an area that can be level
};

/// Returns the distance of a place from the nearest edge of an area.
double shoreDistanceM(const PlanRings& area, const glm::dvec2& place);

/// Returns the heights of the ground at the shore of an area, each 10 m, the lowest first: the lower of a
/// place of the shore and of one 8 m beyond, since a pool on a slope ends where the ground falls. Nothing:
/// some place has no ground.
std::optional<std::vector<double>> shoreOf(const PlanRings& rings, const foundation::HeightInPlan& ground);

} // namespace worldmaking
