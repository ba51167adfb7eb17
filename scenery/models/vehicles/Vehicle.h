// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "scenery/models/Model.h"
#include "scenery/models/vehicles/Body.h"
#include "scenery/models/vehicles/VehicleLook.h"

namespace scenery::models
{

/// Generates a vehicle standing on its wheels. Seeds choose its colour and stretch it. Pure. Surfaces: body
/// (lacquered, the sheet of the look), wheels. 3 000 to 10 000 triangles.
Model makeVehicle(const std::shared_ptr<const VehicleLook>& look, std::uint64_t seed);

/// Adds the body and the mirrors of a vehicle, without wheels. Frame: the model's, x = 0 in the middle of the
/// vehicle.
void addVehicleShell(ModelBuilder& builder, const std::shared_ptr<const VehicleLook>& look,
                     const StretchedForm& body, const glm::vec3& tint);

} // namespace scenery::models
