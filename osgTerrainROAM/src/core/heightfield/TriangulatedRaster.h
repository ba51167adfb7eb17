// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include "GdalSession.h"
#include "RasterFile.h"

namespace osgTerrainROAM::core
{

/// Whether the name of a file is that of a multi-triangulation (.mt).
bool isTriangulation(const std::filesystem::path& file);

/// Samples a multi-triangulation as a raster: at its lattice where that has no more than 4097 points a side,
/// else evenly, with a note. Its georeference is that of the file; without one it is a plane in metres. Where
/// there is no surface the raster is outside.
/// Errors: not a .mt file, another version, damaged head, directory or main part. Other damaged trees are
/// coarse, with a note.
foundation::Result<Raster> readTriangulation(const std::filesystem::path& file, GdalSession& gdal);

/// The same without the samples, whose errors are not found.
foundation::Result<Raster> readTriangulationHead(const std::filesystem::path& file);

} // namespace osgTerrainROAM::core
