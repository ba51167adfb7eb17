// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// Walls, 256 × 256, to be repeated both ways (kWallPictureM), light, to be tinted.
Picture paintPlaster();
Picture paintBricks();
/// Trapezoidal sheet, its ribs upright.
Picture paintSheetMetal();
/// Upright boards.
Picture paintPlanks();

} // namespace scenery::models
