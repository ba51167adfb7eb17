// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "worldmaking/madeup/AreaSet.h"
#include "worldmaking/madeup/Drainage.h"
#include "worldmaking/madeup/GroundGrid.h"
#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

/// Lays lakes into the most level ground by a stream: their shore leaves the ground at their middle by
/// kMostShoreM at most.
/// `avoided`: where none is. Returns their outlines, at most `most`, kApartM from each other.
std::vector<PlanRings> lakesOn(const GroundGrid& ground, const Drainage& drainage, std::uint64_t seed,
                               std::size_t most, const AreaSet& avoided);

inline constexpr double kMostShoreM = 1.2;

} // namespace worldmaking
