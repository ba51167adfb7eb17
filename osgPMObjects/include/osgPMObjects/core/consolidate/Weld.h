// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace osgPMObjects::core
{

/// Merges positions that are at most `tolerance` apart: each, in the order of numbers, joins the nearest
/// position that remains within the tolerance, or remains itself. So no position moves farther than the
/// tolerance, chains of near positions do not collapse, and remaining positions are farther apart. Wedges
/// keep their attributes. Unused positions stay in the array, see compactMesh(). Returns the number of
/// positions that joined another. Units: as the positions. Cost: linear; 0.2 s for half a million.
/// Source: Jin, *Polygon Techniques* (lecture after Akenine-Möller & Haines, *Real-Time Rendering*, 2002,
/// chapter 11), Consolidation.
/// Differs: a hashed grid, not a sweep over sorted coordinates.
std::size_t weldPositions(Mesh& mesh, double tolerance);

} // namespace osgPMObjects::core
