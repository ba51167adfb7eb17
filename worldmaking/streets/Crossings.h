// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "worldmaking/streets/CrossedWays.h"
#include "worldmaking/streets/Overpass.h"

namespace worldmaking
{

/// Where a street and a railway have a point in common. Units: metres along the centre lines.
struct LevelPlace
{
    std::size_t street = 0, track = 0; ///< chains
    double streetM = 0.0, trackM = 0.0;
};

/// What heights have to keep where ways cross.
struct Crossings
{
    std::vector<Overpass> overpasses;
    std::vector<Overpass> leftOpen;   ///< crossings that the map leaves open
    std::vector<Overpass> footLevels; ///< with the bridge of a path between both
    std::vector<LevelPlace> levels;
    std::vector<CrossedPlace> crossed;
    std::size_t tracks = 0; ///< the first chain of a railway
};

} // namespace worldmaking
