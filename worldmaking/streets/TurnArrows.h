// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <osgRoads/core/network/Road.h>

#include "worldmaking/streets/StreetGraph.h"

namespace worldmaking
{

/// Paints the arrows of `turn:lanes` onto the lanes of a road before the crossings at its ends: objects of
/// the type roadMark, one 8 m before the end, another 30 m before it where the street is long enough.
void addTurnArrows(const StreetGraph& graph, const StreetChain& chain, osgRoads::core::Road& road);

/// The subtype of OpenDRIVE for an entry of turn:lanes ("left;through": arrowStraightLeft); empty: no arrow.
std::string arrowSubtypeOf(std::string_view turns);

} // namespace worldmaking
