// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// Barks, 256 × 256, to be repeated both ways; along the limb is up.
Picture paintOakBark();
Picture paintPineBark();
Picture paintBirchBark();

} // namespace scenery::models
