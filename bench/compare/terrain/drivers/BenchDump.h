// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "compare/terrain/drivers/BenchRun.h"

namespace terraintool
{

/// Returns a sink that writes frames of a run into a folder, for checks by other programs. A frame is two
/// files, DEM-DRIVER-PATH-TOLERANCE-FRAME.json with the eye, the matrix (projection × view, column after
/// column), the size of the picture and the tolerance, and a .bin with the triangles: for each corner, apex
/// first, x, y, z and column, row as five little-endian doubles. Frame: the tile's. Units: metres, samples,
/// pixels. Errors: a file cannot be written.
FrameSink dumpTo(const std::filesystem::path& folder, const BenchRun& run);

} // namespace terraintool
