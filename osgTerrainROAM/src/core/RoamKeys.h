// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <osgTerrainROAM/core/RoamFile.h>

#include "RoamEntry.h"

namespace osgTerrainROAM::core
{

/// The names of all keys, for messages.
std::string roamKeyNames();

/// Whether a key may appear in several lines.
bool repeatsInRoamFile(std::string_view key);

/// Applies a line to the description. Errors: no value, an unknown key, a value that the key cannot have.
foundation::Outcome assignRoamEntry(RoamFile& file, const RoamEntry& entry);

} // namespace osgTerrainROAM::core
