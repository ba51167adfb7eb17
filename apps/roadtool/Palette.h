// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgRoads/core/network/RoadMark.h>

#include "roadtool/TopView.h"

namespace roadtool
{

inline constexpr Colour kGround{222, 226, 210}, kObject{120, 100, 84}, kSignal{200, 40, 40};

/// Returns the colour of a lane of that type.
Colour colourOf(osgRoads::core::LaneType type);

/// Returns the colour of a road mark.
Colour colourOf(osgRoads::core::MarkColour colour);

} // namespace roadtool
