// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <foundation/Result.h>

#include "simulation/vehicle/road/RoadVehicleData.h"

namespace simulation
{

/// Reads the data file of a type of road vehicle (docs/reference/road-vehicle-file.md). The file of its look
/// is named relative to it, and not read.
/// Errors: those of the file and of XML; an element or attribute that is unknown, missing, given twice or
/// outside its range; a table that is none; a source that is not listed; axles, gears or masses with which
/// nothing stands or drives. Each names file, line and remedy.
foundation::Result<RoadVehicleData> readRoadVehicle(const std::filesystem::path& file);

/// The same from a text; `name` stands for the file in errors.
foundation::Result<RoadVehicleData> parseRoadVehicle(std::string_view text, const std::string& name);

} // namespace simulation
