// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/roads/things/RoadThings.h"

namespace scenery::roads
{

/// Returns the upright axes of something on a road that looks `headingRad` to the left of the road. Frame:
/// the scene's.
glm::dmat3 uprightAxes(const osgRoads::core::PlacedNetwork& placed, int road, double s, double t,
                       double headingRad);

/// Returns axes that are pitched about their y, then rolled about their x.
glm::dmat3 tiltedAxes(const glm::dmat3& upright, double pitchRad, double rollRad);

/// Returns the heading of a signal to its road: its orientation and its own offset.
double headingOf(const osgRoads::core::Signal& signal);

} // namespace scenery::roads
