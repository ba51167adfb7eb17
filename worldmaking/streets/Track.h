// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include "worldmaking/streets/WayLevel.h"

namespace worldmaking
{

/// A stretch of a railway with its heights, made of one way of the map. Units: metres in the plan and in the
/// datum of the ground.
struct Track
{
    std::size_t shape = 0; ///< of the map
    std::vector<glm::dvec2> points;
    std::vector<double> heightsM; ///< of the formation at each point: kRailTopM below the top of the rails
    StreetPlace place = StreetPlace::ground;
    bool isOffGround = false; ///< it needs a cutting or an embankment somewhere
    bool isInStreet = false;  ///< its rails lie in the surface of a street, which carries them
    bool isPortalAtStart = false, isPortalAtEnd = false; ///< of a tunnel
    /// of a tunnel: the track beside is in the same tube
    bool isOpenLeft = false, isOpenRight = false;
};

} // namespace worldmaking
