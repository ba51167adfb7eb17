// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/KeptFrom.h>

#include <osg/StateSet>

#include <osgTerrainROAM/core/features/FeatureCells.h>

namespace osgTerrainROAM
{

/// Adds the inputs of shaders/Feature*.glsl to a StateSet, but FarFeatures.glsl: four textures from unit
/// `firstUnit` on, and uniforms. Cells and records are float textures that are fetched, not filtered. The far
/// maps hold shares, filtered over each texel and mip-mapped.
/// Memory: as FeatureCells, and two far maps of up to 4096×4096 texels of 4 B; a texel is between an eighth
/// of a cell and a whole cell. Cost: about 1 µs a texel of the far maps where something is painted; several
/// threads.
void addFeatureTextures(osg::StateSet& stateSet, const core::FeatureCells& cells, int firstUnit,
                        const foundation::KeptFrom& kept);

/// Adds the inputs of shaders/FarFeatures.glsl: one such map, of beds, at `unit`, with texels of a sixteenth
/// of a cell or more.
void addFarFeatureTexture(osg::StateSet& stateSet, const core::FeatureCells& cells, int unit,
                          const foundation::KeptFrom& kept);

} // namespace osgTerrainROAM
