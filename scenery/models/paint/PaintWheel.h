// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// A wheel seen from outside, filling 256 × 256: tyre, rim with five double spokes, bolts.
Picture paintWheel();

} // namespace scenery::models
