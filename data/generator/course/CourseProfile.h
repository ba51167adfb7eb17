// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgRoads/core/geometry/Cubic.h>

#include "Terrain.h"
#include "course/Alignment.h"

namespace islandgen
{

/// Steeper than this no course is.
inline constexpr double kSteepestGrade = 0.07;

/// Returns the height of the terrain, linear between its samples. Frame: metres east and north of its middle.
double groundAt(const Terrain& terrain, const glm::dvec2& place);

/// The heights along a closed course, at equal distances; the first follows on the last. Metres above mean
/// sea level.
struct CourseHeights
{
    double stepM = 0.0;
    std::vector<double> groundM, roadM;
};

/// Follows the ground's heights, smoothed over `smoothM`, with grades of kSteepestGrade at most, at least 2.5
/// m above the sea.
CourseHeights courseHeights(const Terrain& terrain, const Alignment& alignment, double stepM, double smoothM);

/// Returns the heights as cubics about 40 m long that join without a kink. Over the end of the course they go
/// on for `beyondM`.
osgRoads::core::CubicProfile profileOf(const CourseHeights& heights, double beyondM);

} // namespace islandgen
