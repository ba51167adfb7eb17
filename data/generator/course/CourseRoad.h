// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "course/Alignment.h"
#include "course/CourseProfile.h"

namespace islandgen
{

/// A stretch along a road, metres from its start.
struct Stretch
{
    double fromM = 0.0, toM = 0.0;
};

/// One road of a course: what of the course lies between two places, with s from 0 at its start. Curvature is
/// positive to the left; frames as Alignment.
struct CourseRoad
{
    double lengthM = 0.0;
    std::vector<osgRoads::core::PlanElement> elements; ///< s from the start of the road
    std::vector<Bend> bends;                           ///< whole ones
    osgRoads::core::CubicProfile elevation;
    osgRoads::core::CubicProfile superelevationRad;
    std::vector<Stretch> noOvertaking;        ///< around bends of little sight
    std::vector<Stretch> leftRail, rightRail; ///< beside embankments
    std::vector<Stretch> tunnels;             ///< where a cutting would be deep
};

/// Cuts a course in the middle of four straights into roads of about the same length, one behind the other.
std::vector<CourseRoad> roadsOf(const Terrain& terrain, const Alignment& alignment,
                                const CourseHeights& heights);

} // namespace islandgen
