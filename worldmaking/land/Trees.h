// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <foundation/Heights.h>
#include <foundation/Result.h>

#include "worldmaking/land/CoverRaster.h"
#include "worldmaking/land/Houses.h"

namespace worldmaking
{

/// A tree or bush. Frame: the plane. Units: metres.
struct Tree
{
    glm::dvec2 place{0.0};
    std::string_view kind; ///< of the generated models
    int seed = 1;
    double scale = 1.0;
};

/// What stands where on the ground, for those that look for a place.
struct TakenGround
{
    const RoadRoom& roads;
    const CoverRaster& cover;
    std::span<const House> houses;
    std::vector<PlanRings> runways; ///< their strips
};

struct TreeReport
{
    std::size_t inWoods = 0, single = 0, inRows = 0, inOrchards = 0, hedges = 0, shrubs = 0, inGardens = 0;
    double spacingM = 0.0; ///< between trees of woods
};

/// Plants woods where the raster has trees, one in each square of a grid, somewhere within it; wider apart
/// where the whole would be more than kMostTrees. Orchards and hedges have rows of bushes, tree rows and
/// single trees those of the map. Gardens have a tree, a bush or nothing in each square of 15 m (wider where
/// they would be more than kMostGardenPlants), none on yards and paths and beside models. Nothing stands
/// within kTreeRoomM of lanes, kWallRoomM of houses, in water, on a runway's strip or where there is no
/// ground. Kinds follow leaf_type, or else the height: above 1500 m most are spruces.
std::vector<Tree> treesOf(const LandMap& map, const MapPlane& plane, const TakenGround& taken,
                          const foundation::HeightInPlan& height, TreeReport& report);

/// Writes them as points with kind, seed and scale. Errors: as MapFile::finish().
foundation::Outcome writeTrees(std::span<const Tree> trees, const MapPlane& plane,
                               const std::filesystem::path& file);

inline constexpr std::size_t kMostTrees = 400000, kMostGardenPlants = 150000;
inline constexpr double kTreeRoomM = 3.5, kWallRoomM = 2.5;

} // namespace worldmaking
