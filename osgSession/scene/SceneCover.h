// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "SceneTerrain.h"
#include "scenery/nodes/GroundCoverNode.h"
#include "scenery/nodes/SkyShadeNode.h"

namespace trainer
{

/// Makes what grows and lies around the eye on a terrain, but not on lanes, nor on what its maps show as
/// water, runway or field. Null: the scene has no terrain, or not in the scene's own frame.
std::unique_ptr<scenery::GroundCoverNode> makeCover(const SceneTerrain& terrain);

/// Makes what darkens the ground where things that stand hide the sky: those of the terrain's maps, which are
/// taken from it, and `more` (null: none). Null: nothing does, or the scene has no terrain.
std::unique_ptr<scenery::SkyShadeNode> makeSkyShade(SceneTerrain& terrain, const scenery::SkyOccluders* more);

} // namespace trainer
