// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include "Terrain.h"

namespace islandgen
{

/// Position of the terrain's middle sample: UTM zone 32 north on WGS84, in the open Ligurian Sea (43.60 N,
/// 8.21 E), where there is no island.
inline constexpr double kCentreEastingM = 436000.0;
inline constexpr double kCentreNorthingM = 4828000.0;

/// Writes a compressed Float32 GeoTIFF, north up, heights in metres above mean sea level. It is written under
/// a temporary name beside `file` and renamed when it is complete.
/// Errors: folder missing or not writable, no space.
foundation::Outcome writeTerrain(const Terrain& terrain, const std::filesystem::path& file);

} // namespace islandgen
