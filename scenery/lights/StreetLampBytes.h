// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenery/lights/StreetLamps.h"

namespace scenery
{

/// Returns lamps as bytes, for streetLampsIn(). Numbers are the machine's.
std::string bytesOf(const std::vector<StreetLamp>& lamps);

/// Absent: bytesOf() did not write them.
std::optional<std::vector<StreetLamp>> streetLampsIn(std::string_view bytes);

} // namespace scenery
