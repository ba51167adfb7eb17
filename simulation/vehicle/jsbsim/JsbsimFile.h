// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <foundation/Result.h>

#include "simulation/vehicle/jsbsim/JsbsimData.h"

namespace simulation
{

/// Whether a data file of an aircraft is one of JSBSim: its root element is `jsbsim_aircraft`. False for a
/// file that cannot be read.
bool isJsbsimFile(const std::filesystem::path& file);

/// Reads a data file that names an aircraft of JSBSim (docs/reference/aircraft-file.md). A root that it names
/// lies beside the file.
/// Errors: those of the file and of XML; an element or attribute that is unknown, missing or outside its
/// range; an input's name that is given twice or is one of FlightInputs. Each names file, line and remedy.
foundation::Result<JsbsimData> readJsbsimAircraft(const std::filesystem::path& file);

/// The same from a text; `name` stands for the file in errors.
foundation::Result<JsbsimData> parseJsbsimAircraft(std::string_view text, const std::string& name);

} // namespace simulation
