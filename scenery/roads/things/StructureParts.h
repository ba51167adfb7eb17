// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgRoads/core/place/TunnelTube.h>
#include <osgRoads/core/query/LaneSpan.h>

#include "scenery/roads/things/RoadLine.h"

/// What bridges and tunnels share.
namespace scenery::roads
{

using Sides = osgRoads::core::RoadSides;

/// Returns the sides so far beyond all lanes.
inline Sides sidesAt(const osgRoads::core::Road& road, double s, double beyondM)
{
    const auto extent = osgRoads::core::extentAt(road, s);
    return {extent.leftT + beyondM, extent.rightT - beyondM};
}

/// A body of concrete along a structure, without its cross-section.
inline RoadLine concreteLine(const osgRoads::core::RoadStructure& structure)
{
    RoadLine line;
    line.s = structure.s;
    line.sEnd = structure.s + structure.length;
    line.surface = {models::Painting::plaster, models::Coat::matt};
    line.tint = {0.62F, 0.61F, 0.58F};
    line.uvPerM = 1.0 / 2.4;
    return line;
}

inline Profile boxProfile(double half, double low, double high)
{
    return {{-half, low}, {half, low}, {half, high}, {-half, high}};
}

/// The cross-section of a tube, and of a portal: a wall with level top around the mouth. A ring: the outside
/// from the left foot over the crown to the right one, then the inside back. `half`: the inside's half width.
Profile tunnelLining(const osgRoads::core::TunnelTube& tube, double half);
Profile tunnelPortal(const osgRoads::core::TunnelTube& tube, double half);

/// The cross-section of a portal behind its front, where it hides the tube that the ground does not cover
/// yet: as the front outside, within the lining inside.
Profile tunnelPortalBack(osgRoads::core::TunnelTube tube, double half);

/// Adds a tunnel: tube, portals and lamps.
void placeTunnel(const osgRoads::core::PlacedNetwork& placed, int road,
                 const osgRoads::core::RoadStructure& tunnel, RoadThings& into);

} // namespace scenery::roads
