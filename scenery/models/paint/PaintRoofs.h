// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// Roofs, 256 × 256, to be repeated both ways (kRoofPictureM), light, to be tinted; the ridge is up.
Picture paintRoofTiles();
Picture paintRoofMetal();

} // namespace scenery::models
