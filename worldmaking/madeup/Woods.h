// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "worldmaking/madeup/Drainage.h"
#include "worldmaking/madeup/GroundGrid.h"
#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

/// What woods have to keep to.
struct WoodRules
{
    const GroundGrid& ground;
    const Drainage& drainage;
    std::function<bool(const glm::dvec2&)> isTaken; ///< by fields, settlements, waters, runways
    double share = 0.25;                            ///< of the land
    double treeLineM = 1800.0;
    std::uint64_t seed = 1;
};

/// Lets woods stand where people leave them: on slopes, along streams, and in patches that noise chooses,
/// below the tree line; as much of them as `share` says. Returns their outlines, none of which comes nearer
/// than a cell of the search to what is taken.
std::vector<PlanRings> woodsOn(const WoodRules& rules);

inline constexpr double kWoodCellM = 16.0;

} // namespace worldmaking
