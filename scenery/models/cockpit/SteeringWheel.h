// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/Model.h"

namespace scenery::models
{

/// Makes a steering wheel with three spokes, one of them downwards. Frame: x to the right, y up, z to the
/// driver, origin in its middle.
Model makeSteeringWheel(double radiusM);

} // namespace scenery::models
