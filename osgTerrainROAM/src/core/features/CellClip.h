// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace osgTerrainROAM::core
{

using Ring = std::vector<glm::dvec2>;

/// Clips each ring to low ≤ coordinate ≤ high of an axis (0 east, 1 north); empty rings are dropped. A ring
/// that leaves the band and returns runs along its border: the even-odd rule stays valid inside the band.
/// Source: Sutherland & Hodgman, *Reentrant Polygon Clipping*, 1974; one slab at a time.
std::vector<Ring> clippedToBand(const std::vector<Ring>& rings, int axis, double low, double high);

} // namespace osgTerrainROAM::core
