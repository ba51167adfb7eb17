// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <foundation/Result.h>

#include <osgTerrainROAM/core/features/GroundFeature.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

#include "request/PlayRequest.h"

namespace trainer
{

/// Lays a level strip into the ground, as high as the ground's mean along it, and returns how it is painted.
/// Errors: it lies beyond the data; as GroundEditor::conform().
foundation::Result<osgTerrainROAM::core::GroundFeature>
layStrip(const std::shared_ptr<osgTerrainROAM::core::RoamTile>& tile, const StripRequest& strip);

/// How a strip is painted onto level ground.
osgTerrainROAM::core::GroundFeature paintedStrip(const StripRequest& strip);

} // namespace trainer
