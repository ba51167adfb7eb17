// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <foundation/Heights.h>

#include <osgTerrainROAM/core/edit/Earthworks.h>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/MapPlane.h"

namespace worldmaking
{

/// What became of the levels of water.
struct WaterReport
{
    std::size_t lakes = 0, rivers = 0;
    std::size_t unlevelled =
        0; ///< areas of rivers without a line, on ground that is not level; they lie on it as it is
    std::size_t beyondGround = 0;
};

/// Lays open water at its level: lakes level, rivers and canals falling in the direction of their lines, both
/// with shores that rise to the ground or are banked up. A lake and the rivers through it have one level
/// where they meet. A river is as wide as the area that its line lies in, or as riverWidthM() says. Streams
/// and ditches stay as the ground is.
/// Frame: the plane.
std::vector<osgTerrainROAM::core::Earthwork> waterWorks(const LandMap& map, const MapPlane& plane,
                                                        const foundation::HeightInPlan& ground,
                                                        WaterReport& report);

} // namespace worldmaking
