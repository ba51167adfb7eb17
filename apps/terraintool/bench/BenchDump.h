// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "terraintool/bench/BenchRun.h"

namespace terraintool
{

/// Writes frames of a run into a folder, for checks by other programs: DEM-DRIVER-PATH-TOLERANCE-FRAME.json with the eye,
/// the matrix (projection × view, column after column), picture and tolerance, and beside it a .bin with the triangles:
/// per corner x, y, z in metres and column, row in samples, five little-endian doubles, apex first.
FrameSink dumpTo(const std::filesystem::path& folder, const BenchRun& run);

} // namespace terraintool
