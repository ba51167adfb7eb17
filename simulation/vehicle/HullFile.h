// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/vehicle/Hull.h"
#include "simulation/vehicle/VehicleFileReader.h"

namespace simulation
{

/// The element `<hull>` of a vehicle's file; places in the frame of the file. `widestM`: of a box. Errors:
/// those of `reader`.
HullData readHull(VehicleFileReader& reader, pugi::xml_node node, std::size_t mostBoxes, double widestM);

} // namespace simulation
