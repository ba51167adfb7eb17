// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <osgTerrainROAM/core/features/GroundOpening.h>

#include "scenery/structures/SquareBeams.h"
#include "scenery/structures/Structure.h"

namespace scenery
{

/// Adds the tube of a railway in a tunnel, and its portals: the cross-section of a street's tunnel, as wide
/// as one track, and open to a track beside it. Needs heights. Frame: the scene's.
void addRailTube(const Structure& railway, SquareBeams& beams);

/// Returns the insides of the tubes of railways, as tunnelOpenings() has those of streets.
std::vector<osgTerrainROAM::core::GroundOpening> railOpenings(std::span<const Structure> structures);

inline constexpr double kRailPortalBackM = 9.0; ///< of a portal, into the hill

} // namespace scenery
