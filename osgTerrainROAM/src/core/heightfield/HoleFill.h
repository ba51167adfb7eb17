// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

namespace osgTerrainROAM::core
{

/// Gives points that no raster reaches the height of the nearest known point. They are not drawn, but normals
/// and bounds of their neighbours use them. `isOutside`: 1 at such points; row-major, as the heights. Does
/// nothing when no height is known.
void fillOutside(std::span<float> heightsM, std::span<const std::uint8_t> isOutside, int columns, int rows);

} // namespace osgTerrainROAM::core
