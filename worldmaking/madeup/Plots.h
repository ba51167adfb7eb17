// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "worldmaking/madeup/MadeShapes.h"
#include "worldmaking/madeup/Settlements.h"
#include "worldmaking/madeup/WayWeb.h"

namespace worldmaking
{

/// Footprints that are taken, as rectangles. Frame: the plane.
class TakenPlots
{
public:
    /// Takes a rectangle unless it comes nearer than `gapM` to one that is taken. Source: separating axes of
    /// two rectangles.
    bool take(const PlanRings& rectangle, double gapM);
    bool isFree(const PlanRings& rectangle, double gapM) const;
    const std::vector<PlanRings>& all() const { return _taken; }

private:
    std::vector<PlanRings> _taken;
    PlanGrid _grid;
};

/// What houses have to keep to.
struct PlotRules
{
    const GroundGrid& ground;
    const WayWeb& web;
    std::function<bool(const glm::dvec2&)> isFree; ///< whether a place may be built on
    std::uint64_t seed = 1;
};

/// Puts houses along the streets of a settlement, their fronts to the street: rows with shops in the middle
/// of a town, blocks around them, houses with sheds outside; farms and barns among the houses of villages. A
/// square and a church stand near the middle. No house comes nearer than kStreetRoomM to a street's paving or
/// kGapM to another that is not of its row.
MadeShapes housesAlong(const Settlement& settlement, int number, const PlotRules& rules, TakenPlots& taken);

/// Lonely farms beside roads between settlements, each with a drive of its own; their drives are added to
/// `web`.
MadeShapes farmsAlong(std::size_t most, const std::vector<Settlement>& settlements, const PlotRules& rules,
                      TakenPlots& taken, WayWeb& web);

inline constexpr double kStreetRoomM = 2.0, kGapM = 3.0;

} // namespace worldmaking
