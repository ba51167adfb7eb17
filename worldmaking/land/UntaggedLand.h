// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include <foundation/Heights.h>

#include "worldmaking/land/CoverRaster.h"
#include "worldmaking/land/Houses.h"

namespace worldmaking
{

/// What woods keep away from where the map has no tags.
struct UntaggedLand
{
    const RoadRoom& roads;
    std::span<const House> houses;
    const foundation::HeightInPlan& height;
    double latitudeDeg = 45.0;
};

/// Puts woods where a map says nothing, so that what is drawn there as wood has
/// trees: on slopes more than on level ground, in patches of some hundred
/// metres, kUntaggedRoomM from houses and 15 m from lanes, up to the tree line of
/// the latitude. Returns how many texels are wood now that were untagged. The
/// rest stays untagged.
std::size_t fillUntaggedLand(CoverRaster& cover, const UntaggedLand& land);

/// Height of the tree line, metres. Source: Körner, *Alpine treelines*, 2012,
/// fig. 4.1, as two straight lines.
double treeLineM(double latitudeDeg);

inline constexpr double kUntaggedRoomM = 60.0;

} // namespace worldmaking
