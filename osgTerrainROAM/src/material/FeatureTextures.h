// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/StateSet>

#include "FeatureMaps.h"

namespace osgTerrainROAM
{

/// Adds the inputs of shaders/Feature*.glsl to a StateSet, but FarFeatures.glsl: four textures from unit
/// `firstUnit` on, and uniforms. Cells and records are float textures that are fetched, not filtered. The far
/// maps hold shares, filtered over each texel and mip-mapped. `maps`: FeatureMaps::of().
void addFeatureTextures(osg::StateSet& stateSet, const FeatureMaps& maps, int firstUnit);

/// Adds the inputs of shaders/FarFeatures.glsl: a map of beds at `unit`. `maps`: FeatureMaps::farOf().
void addFarFeatureTexture(osg::StateSet& stateSet, const FeatureMaps& maps, int unit);

} // namespace osgTerrainROAM
