// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include <osgTerrainROAM/core/RoamFile.h>
#include <osgTerrainROAM/core/features/GroundFeature.h>
#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include <osgTerrainROAM/RoamTerrain>
#include <osgTerrainROAM/TerrainMaterial>

namespace osgTerrainROAM
{

/// Gives a material all features that a description names, and more. Returns their report, and tells of what
/// is not painted through osg::notify(NOTICE). Where the sources have marks (foundation::markOfSoleFile()),
/// what is painted is kept as a whole: the second time nothing is imported. Errors: as importFeatures() and
/// FeatureCells::build().
foundation::Result<core::FeatureReport> paintFeatures(TerrainMaterial& material,
                                                      const core::RoamFile& description,
                                                      const core::PlacedTile& tile, const MoreFeatures& more);

} // namespace osgTerrainROAM
