// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgRoads/core/surface/Decal.h>

namespace osgRoads::core
{

/// Adds the markings of an object, along its sides or its outlines, for each time that it stands on the road.
/// Along a side they begin at its rear or its right end. Without length and width the sides are those of its
/// outlines.
void addMarkings(const PlacedNetwork& network, int road, const RoadObject& object, std::vector<Decal>& into);

} // namespace osgRoads::core
