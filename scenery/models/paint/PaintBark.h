// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// Paints bark, 256 × 256, periodic in both axes; up is along the limb.
Picture paintOakBark();
Picture paintPineBark();
Picture paintBirchBark();

} // namespace scenery::models
