// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgRoads/core/place/TunnelTube.h>
#include <osgTerrainROAM/core/features/GroundOpening.h>

namespace scenery
{

/// Returns the cross-section that a tube takes from the ground, without a line.
osgTerrainROAM::core::GroundOpening emptyOpening(const osgRoads::core::TunnelTube& tube);

/// Returns the insides of all tunnels, up to the middle of their linings, so that the border of the ground
/// lies within concrete.
/// Frame: the scene's. Units: metres.
std::vector<osgTerrainROAM::core::GroundOpening> tunnelOpenings(const osgRoads::core::PlacedNetwork& roads,
                                                                const osgRoads::core::TunnelTube& tube = {});

/// Returns whether a height at a matched place lies in the tube of a tunnel, as tunnelOpenings() has it.
bool isInTunnel(const osgRoads::core::PlacedNetwork& roads, const osgRoads::core::RoadMatch& match,
                double heightM, const osgRoads::core::TunnelTube& tube = {});

} // namespace scenery
