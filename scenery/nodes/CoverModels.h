// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <osgPMObjects/ProgressiveShape>
#include <osgTerrainROAM/TerrainMaterial>

#include "scenery/placement/GroundCover.h"

namespace scenery
{

/// The shapes of a GroundCoverNode, by CoverShape: a tuft of grass 0.22 m high, a herb with flowers, a stone
/// 0.12 m wide, twigs and leaves. Colours of plants and stones are those of the material's palette. Cost:
/// some milliseconds.
std::array<osg::ref_ptr<const osgPMObjects::ProgressiveShape>, kCoverShapes>
coverModels(const osgTerrainROAM::TerrainMaterial& material);

} // namespace scenery
