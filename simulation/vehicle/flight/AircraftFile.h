// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <foundation/Result.h>

#include "simulation/vehicle/flight/AircraftData.h"

namespace simulation
{

/// Reads the data file of a type of aircraft (docs/reference/aircraft-file.md).
/// Errors: those of the file and of XML; an element or attribute that is unknown, missing, given twice or
/// outside its range; a table that is none; a source that is not listed; mass or inertia that no body has.
/// Each names file, line and remedy.
foundation::Result<AircraftData> readAircraft(const std::filesystem::path& file);

/// The same from a text; `name` stands for the file in errors.
foundation::Result<AircraftData> parseAircraft(std::string_view text, const std::string& name);

} // namespace simulation
