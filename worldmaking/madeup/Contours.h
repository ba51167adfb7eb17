// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "worldmaking/plan/PlanGrid.h"
#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

/// Returns the areas of a box where values exceed a level, smooth outlines with holes, of at least `leastM2`.
/// `values`: at the middles of squares of `cellM`, `columns` a row, the southernmost row first. Empty where
/// GDAL cannot.
/// Source: GDAL's contour generator (marching squares).
std::vector<PlanRings> areasAbove(const std::vector<float>& values, int columns, const MapBox& box,
                                  double cellM, double level, double leastM2);

} // namespace worldmaking
