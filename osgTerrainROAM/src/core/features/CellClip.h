// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace osgTerrainROAM::core
{

using Ring = std::vector<glm::dvec2>;

/// The part of each ring within low ≤ coordinate ≤ high of an axis (0 east, 1 north); rings that vanish are dropped.
/// Where a ring leaves the band and comes back it runs along the border: even-odd inside the band is kept.
/// Source: Sutherland and Hodgman, Reentrant polygon clipping (1974), one slab at a time.
std::vector<Ring> clippedToBand(const std::vector<Ring>& rings, int axis, double low, double high);

} // namespace osgTerrainROAM::core
