// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// Paints a wheel seen from outside over all 256 × 256 pixels: tyre, rim with five double spokes, bolts.
Picture paintWheel();

} // namespace scenery::models
