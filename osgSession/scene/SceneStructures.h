// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include <osgTerrainROAM/core/RoamFile.h>

#include "SceneTerrain.h"

namespace trainer
{

/// Adds what a .roam file's `structures` put on the ground: walls, fences, power lines, railways, wind
/// turbines; and what stands at the runways of the scene: approach lights (PAPI) at both ends of paved ones
/// of kLeastPapiM or more, and windsocks where `structures` has them. Errors: those of importShapes(); a
/// source without anything that can stand here.
foundation::Outcome addStructures(const osgTerrainROAM::core::RoamFile& description, SceneTerrain& scene);

inline constexpr double kLeastPapiM = 600.0;

} // namespace trainer
