// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/paint/Picture.h"

namespace scenery::models
{

struct VehicleLook;

/// Paints the views of a vehicle from the side, above, front and behind (vehicles/VehicleForm.h), 1024 ×
/// 1024. Alpha is the share of the tint: bodywork, not glass, lamps and tyres.
Picture paintVehicle(const VehicleLook& look);

} // namespace scenery::models
