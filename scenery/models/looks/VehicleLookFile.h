// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <foundation/Result.h>

#include "scenery/models/vehicles/VehicleLook.h"

namespace scenery::models
{

/// Reads a look from its JSON text (docs/reference/vehicle-look-file.md). `name`: of the file, for messages.
/// Errors: no JSON, with the line; a member that is unknown or missing, a word that is none, a number out of
/// range, a shape of which no closed body can be made: each with its JSON pointer and the remedy.
foundation::Result<VehicleLook> parseVehicleLook(std::string_view text, const std::string& name);

/// Errors: cannot be read, larger than 4 MB; as parseVehicleLook().
foundation::Result<VehicleLook> readVehicleLook(const std::filesystem::path& file);

} // namespace scenery::models
