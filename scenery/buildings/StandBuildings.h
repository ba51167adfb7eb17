// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include <foundation/Heights.h>

#include <osgTerrainROAM/core/features/ShapeImport.h>

#include "scenery/buildings/Building.h"

namespace scenery
{

/// Returns the nearest place of a street in the plan from a place on the ground; nothing where none is near.
using NearestStreet = std::function<std::optional<glm::dvec2>(const glm::dvec3& place)>;

/// The buildings of a map on the ground, and what was left out.
struct StandingBuildings
{
    std::vector<StandingBuilding> buildings;
    std::size_t beyondGround = 0, unusable = 0;
};

/// Makes buildings of a map's areas (buildingOf()) and points (towerOf()) and puts them on the ground. The
/// door is on the side of the nearest street, or on the longest one, and the floor at the ground there;
/// higher where more than kMostWallSunkM of a wall would lie in the ground, but not by so much that walls
/// show below the floor for more than kMostCellarM and half the eaves. Walls go down to the lowest ground and
/// half a metre into it. Parts of one building (kWholeTag) have one floor, that of the largest on the ground;
/// one that lies kPassedM above it or more, where vehicles may pass, keeps so far above the ground below it.
/// Those that would lie in the ground there, up a slope, have a floor of their own: they show kMostWallSunkM
/// of their walls or more.
StandingBuildings standBuildings(const osgTerrainROAM::core::ShapeSet& shapes,
                                 const foundation::HeightInPlan& ground, const NearestStreet& street = {});

/// The lowest and the highest ground under an outline, at its corners and each metre along its edges.
struct GroundSpan
{
    double lowM = 0.0, highM = 0.0;
};
std::optional<GroundSpan> groundUnder(const std::vector<std::vector<glm::dvec2>>& rings,
                                      const foundation::HeightInPlan& ground);

/// The tag of a part that names the building which it is a part of.
inline constexpr std::string_view kWholeTag = "part_of";

inline constexpr double kPassedM = 4.5;       ///< free height of what vehicles pass below
inline constexpr double kFootM = 0.5;         ///< of walls in the lowest ground
inline constexpr double kMostWallSunkM = 2.4; ///< of the uphill walls
inline constexpr double kMostCellarM = 3.0;

} // namespace scenery
