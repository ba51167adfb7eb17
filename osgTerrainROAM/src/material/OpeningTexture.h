// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/StateSet>

#include <osgTerrainROAM/core/features/OpeningCells.h>

namespace osgTerrainROAM
{

/// Adds the inputs of shaders/GroundOpenings.glsl to a StateSet: one texture of floats, which is fetched, not
/// filtered, and uniforms. The texture holds a texel for each cell, [first texel of its list, pieces, 0, 0],
/// then the records. `cells`: not empty.
void addOpeningTexture(osg::StateSet& stateSet, const core::OpeningCells& cells, int unit);

} // namespace osgTerrainROAM
