// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgRoads/core/surface/Decal.h>

namespace osgRoads::core
{

/// Adds the explicit lines of the marks of a road, in straight pieces that lie within 5 mm of the border and
/// are at most 16 m long.
void addExplicitMarks(const PlacedNetwork& network, int road, std::vector<Decal>& into);

} // namespace osgRoads::core
