// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

/// Vehicles from the side, from above, from the front and from behind (vehicles/VehicleForm.h), 1024 × 1024. Alpha is how far a
/// tint counts: bodywork, not glass, lamps, tyres.
Picture paintSaloon();
Picture paintVan();
Picture paintBus();

} // namespace scenery::models
