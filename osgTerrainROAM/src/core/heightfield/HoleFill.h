// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

namespace osgTerrainROAM::core
{

/// Gives places that no raster reaches the heights of the nearest that are known: nothing is drawn there, but normals and bounds
/// beside them look across. `isOutside`: 1 at such places; row-major, as the heights. Nothing happens where none is known.
void fillOutside(std::span<float> heightsM, std::span<const std::uint8_t> isOutside, int columns, int rows);

} // namespace osgTerrainROAM::core
