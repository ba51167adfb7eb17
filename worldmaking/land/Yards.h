// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "worldmaking/land/CoverRaster.h"
#include "worldmaking/land/Houses.h"

namespace worldmaking
{

/// Makes yards of gardens where houses stand close, as in the middle of a town: where they cover more than
/// kYardShare of the square of kYardLookM around a texel. Returns how many texels became yards. A house
/// counts as if it lay evenly over its box.
std::size_t layYards(CoverRaster& cover, std::span<const House> houses);

inline constexpr double kYardShare = 0.3, kYardLookM = 50.0;

} // namespace worldmaking
