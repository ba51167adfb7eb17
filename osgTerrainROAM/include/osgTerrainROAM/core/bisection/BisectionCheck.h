// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include <osgTerrainROAM/core/bisection/BisectionMesh.h>

namespace osgTerrainROAM::core
{

/// Checks by brute force that drawn triangles have each side with one neighbour, which has it the other way,
/// or on the border of the coarse mesh: no crack, no T-junction, no triangle that is turned. Returns what is
/// wrong.
std::optional<std::string> checkDrawn(const BisectionSurface& surface, std::span<const DrawnBisector> drawn);

/// Returns by brute force the greatest share of its tolerance by which a point of the finest surface is off,
/// over all vertices and all points of patches: 1 is what the view allows.
double worstShare(const BisectionMesh& mesh, const BisectionView& view);

} // namespace osgTerrainROAM::core
