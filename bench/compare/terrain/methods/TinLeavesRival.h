// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include <osgTerrainROAM/core/roam/RoamTile.h>

#include "compare/terrain/methods/Rival.h"

namespace terraintool
{

/// Prepares ROAM over half-edges with TINs in triangles ("tin-leaves"): one triangle with legs of 16 cells in
/// each square of 64 cells carries a TIN of as many of its samples as keep the others within `errorM`
/// (vertical, Delaunay, worst samples first). More of them would lie side by side, and one that is shown
/// would show all. It takes neither a ceiling nor a limit of time. Nothing: the tile is no square of 2^n + 1
/// samples, from 65 to 1025.
/// Precondition: a planar tile without holes. Cost and memory: BisectionSurface, BisectionMesh.
std::optional<Rival> tinLeavesRival(const std::shared_ptr<const osgTerrainROAM::core::RoamTile>& tile,
                                    double errorM);

} // namespace terraintool
