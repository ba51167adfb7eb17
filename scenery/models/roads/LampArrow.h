// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenery/models/roads/RoadModel.h"

namespace scenery::models
{

/// Returns the arrow of a lamp as convex polygons that do not overlap, in a circle of radius 1: x to the left
/// as the driver sees it, y up; counter-clockwise in these axes. Empty without an arrow.
std::vector<std::vector<glm::dvec2>> arrowPieces(RoadModel::Arrow arrow);

} // namespace scenery::models
