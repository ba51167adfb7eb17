// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <osgTerrainROAM/core/features/ShapeImport.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace trainer
{

/// Reads the points, areas and lines of a source of a world, or finds what it held the last time. Errors:
/// those of importShapes().
foundation::Result<osgTerrainROAM::core::ShapeSet> readShapes(const std::filesystem::path& source,
                                                              const osgTerrainROAM::core::RoamTile& tile);

} // namespace trainer
