// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/bisection/BisectionPatch.h>

namespace osgTerrainROAM::core
{

/// Reads the points of a file of triangles and makes a TIN of them in the smallest triangle above the last
/// level that holds them all, seen from above. Errors: of the file; no triangle holds them all; the TIN is
/// not sound (checkPatch).
foundation::Result<BisectionPatch> readPatch(const BisectionSurface& surface,
                                             const std::filesystem::path& file);

/// Whether a triangle is another, or lies in it.
bool isWithin(Bisector t, Bisector outer);

} // namespace osgTerrainROAM::core
