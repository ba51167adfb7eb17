// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// Paints a wall, 256 × 256, periodic in both axes (kWallPictureM), light so that it can be tinted.
Picture paintPlaster();
Picture paintBricks();
/// Paints trapezoidal sheet metal with upright ribs.
Picture paintSheetMetal();
/// Paints upright boards.
Picture paintPlanks();

} // namespace scenery::models
