// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "scenery/models/entities/EntityShape.h"
#include "scenery/models/vehicles/VehicleLook.h"

namespace scenery::models
{

/// Returns the look of a shape of kind car, van or bus: its own, else the built-in one of its kind and body.
std::shared_ptr<const VehicleLook> lookOf(const EntityShape& shape);

} // namespace scenery::models
