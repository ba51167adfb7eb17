// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <osgTerrainROAM/core/features/ShapeImport.h>

#include "scenery/buildings/Building.h"

namespace scenery
{

/// Returns the height of the ground in the scene's z; nothing beyond the data.
using GroundHeight = std::function<std::optional<double>(double eastM, double northM)>;

/// The buildings of a map on the ground, and what was left out.
struct StandingBuildings
{
    std::vector<StandingBuilding> buildings;
    std::size_t beyondGround = 0, unusable = 0;
};

/// Makes buildings of a map's areas (buildingOf()) and points (towerOf()) and puts them on the ground: the floor at the highest
/// ground under the outline, or lower where it falls by more than a storey; walls down to the lowest and half a metre into it.
StandingBuildings standBuildings(const osgTerrainROAM::core::ShapeSet& shapes, const GroundHeight& ground);

/// The lowest and the highest ground under an outline, at its corners and each metre along its edges.
struct GroundSpan
{
    double lowM = 0.0, highM = 0.0;
};
std::optional<GroundSpan> groundUnder(const std::vector<std::vector<glm::dvec2>>& rings,
                                      const GroundHeight& ground);

inline constexpr double kFootM = 0.5; ///< of walls in the lowest ground
inline constexpr double kMostCellarM =
    3.0; ///< by which walls may show below the floor before the floor is lowered

} // namespace scenery
