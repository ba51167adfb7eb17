// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pugixml.hpp>

#include "course/CourseRoad.h"

namespace islandgen
{

/// Widths of the lanes and shoulders of a course, metres, and its speed limit.
inline constexpr double kLaneM = 3.5, kShoulderM = 1.0;
inline constexpr int kSpeedLimitKmh = 80;

/// Writes delineator posts every 50 m on both sides, guard rails beside embankments, and tunnels.
void writeObjects(pugi::xml_node road, const CourseRoad& course);

/// Writes the signs for both directions: the speed limit at the ends, a warning 90 m before each tight bend.
/// Source of the types: Katalog der Verkehrszeichen (VzKat, 2017), numbers 103 and 274.
void writeSignals(pugi::xml_node road, const CourseRoad& course);

} // namespace islandgen
