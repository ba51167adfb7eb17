// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/StateSet>

#include <osgTerrainROAM/core/features/FeatureCells.h>

namespace osgTerrainROAM
{

/// Gives a StateSet what shaders/Feature*.glsl read: four textures from unit `firstUnit` on, and uniforms. Cells and records are
/// float textures that are fetched, not filtered; the far maps hold shares, filtered over a texel each and mip-mapped.
/// Memory: as FeatureCells, and up to 4096×4096 texels of 4 B in each of two far maps (a texel is an eighth of a cell to a
/// whole one). Cost: about 1 µs a texel of the far maps where something is painted; several threads.
void addFeatureTextures(osg::StateSet& stateSet, const core::FeatureCells& cells, int firstUnit);

} // namespace osgTerrainROAM
