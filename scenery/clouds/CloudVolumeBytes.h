// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "scenery/clouds/CloudVolume.h"

namespace scenery::clouds
{

/// Returns a layer of clouds as bytes, for cloudVolumeIn(). Numbers are the machine's.
std::string bytesOf(const CloudVolume& volume);

/// Absent: bytesOf() did not write them.
std::optional<CloudVolume> cloudVolumeIn(std::string_view bytes);

} // namespace scenery::clouds
