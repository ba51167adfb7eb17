// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <osgTerrainROAM/core/roam/RoamTile.h>

#include "compare/terrain/methods/Rival.h"

namespace terraintool
{

/// Prepares a split multi-triangulation ("multi-triangulation"): fragments in the trees of a forest, all of
/// them in memory. Its errors are vertical, so its tolerance is one of the vertical distance; it takes
/// neither a ceiling nor a limit of time.
/// Precondition: a planar tile without holes. Cost and memory: osgMultiTriangulation's buildForest().
/// Source: *Multi-Triangulation as applied to very large terrains visualization* (Graphicon 2005).
Rival multiTriangulationRival(const std::shared_ptr<const osgTerrainROAM::core::RoamTile>& tile);

} // namespace terraintool
