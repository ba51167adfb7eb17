// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgRoads/core/network/Road.h>

namespace osgRoads::core
{

/// The cross-section of a tunnel: a tube around the paved lanes, upright, with a walkway on each side.
/// Heights are above the road's surface in the tube's middle. What is drawn, what is cut from the ground and
/// what wheels stand on have it from here.
/// Units: metres. Source of the clearance of 4.5 m and above: German RABT, Richtlinien für die Ausstattung
/// und den Betrieb von Straßentunneln, 2006.
struct TunnelTube
{
    double besideM = 1.0;                        ///< from the paved lanes to the wall: the walkway
    double walkwayM = 0.15;                      ///< height of the walkway above the edge of the lanes
    double wallM = 4.6;                          ///< the inside at the walls
    double kneeM = 5.9;                          ///< at kKneeShare of the half width
    double crownM = 6.2;                         ///< in the middle
    double feetM = -2.0;                         ///< where the walls end
    double liningM = 0.6;                        ///< thickness
    double portalSideM = 1.8, portalRoofM = 1.4; ///< of a portal's front, beyond the tube's outside
    double portalM = 0.8;                        ///< thickness of the front

    static constexpr double kKneeShare = 0.6;
};

/// The t of both sides of something along a road.
struct RoadSides
{
    double left = 0.0, right = 0.0;
    double middle() const { return 0.5 * (left + right); }
    double half() const { return 0.5 * (left - right); }
};

/// Returns the sides of the paved lanes: what a file has beside them as `none` lies outside of tunnels.
RoadSides pavedSides(const Road& road, double s);

/// Returns the inside of a tunnel's walls.
RoadSides tunnelSides(const Road& road, double s, const TunnelTube& tube);

/// Returns how deep s lies in a tunnel, from its nearest portal: negative outside. An end at the road's own
/// end is no portal.
double depthInTunnel(const Road& road, const RoadStructure& tunnel, double s);

} // namespace osgRoads::core
