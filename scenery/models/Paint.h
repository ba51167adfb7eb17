// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/Model.h"
#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// Paints a texture. Pure: the same bytes always. `look`: whose sheet Painting::vehicle is; null for all
/// others. Cost: about 10 to 100 ms.
Picture paint(Painting painting, const VehicleLook* look = nullptr);

} // namespace scenery::models
