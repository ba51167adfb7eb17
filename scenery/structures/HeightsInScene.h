// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "scenery/structures/Structure.h"

namespace scenery
{

/// Puts the heights of a railway, which structureOf() has in the datum of the samples, into the frame of the
/// scene. Where a point has no ground the heights go, and the railway counts as one on the ground.
void putHeightsInScene(Structure& structure, const osgTerrainROAM::core::PlacedTile& tile);

} // namespace scenery
