// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <viewlod/Result.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace terraintool
{

/// The views of `frames` moments, evenly spread, of the tour that `trainer tour` flies over a terrain; 960×540 pixels.
/// Frame: the tile's local frame.
viewlod::Result<std::vector<viewlod::ViewState>> tourViews(const osgTerrainROAM::core::PlacedTile& tile,
                                                           int frames);

} // namespace terraintool
