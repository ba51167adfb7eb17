// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// Paints a roof, 256 × 256, periodic in both axes (kRoofPictureM), light so that it can be tinted; the ridge
/// is up.
Picture paintRoofTiles();
Picture paintRoofMetal();

} // namespace scenery::models
