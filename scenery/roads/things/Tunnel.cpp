// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgRoads/core/place/TunnelTube.h>

#include "scenery/roads/things/StructureParts.h"
#include "scenery/roads/things/ThingPose.h"

namespace scenery::roads
{

namespace
{

using osgRoads::core::PlacedNetwork;
using osgRoads::core::Road;
using osgRoads::core::RoadSides;
using osgRoads::core::RoadStructure;
using osgRoads::core::tunnelSides;
using osgRoads::core::TunnelTube;

constexpr double kLampEveryM = 10.0, kLampLengthM = 1.6, kLampWidthM = 0.35;
constexpr double kKnee = TunnelTube::kKneeShare;
constexpr double kPortalBackM = 7.0; ///< of a portal, into the hill: so far the ground rises over the tube

/// A ring around the inside of the tube, from the right foot over the crown to the left one and back.
Profile ringAround(const TunnelTube& tube, double half, Profile outside)
{
    const Profile inside{{-half, tube.feetM}, {-half, tube.wallM},        {-kKnee * half, tube.kneeM},
                         {0.0, tube.crownM},  {kKnee * half, tube.kneeM}, {half, tube.wallM},
                         {half, tube.feetM}};
    outside.insert(outside.end(), inside.begin(), inside.end()); // outside counter-clockwise, inside back
    return outside;
}

/// Adds a walkway between lanes and wall. `side`: 1 to the left.
void addWalkway(const PlacedNetwork& placed, int road, const TunnelTube& tube, int side, RoadLine line,
                RoadThings& into)
{
    line.body.reset(); // low enough for wheels
    line.tint = {0.50F, 0.50F, 0.49F};
    line.lineT = [&plain = placed.road(road), side](double s)
    {
        const RoadSides paved = osgRoads::core::pavedSides(plain, s);
        return side > 0 ? paved.left : paved.right;
    };
    const double wide = tube.besideM + 0.5 * tube.liningM;
    const Profile box{{side > 0 ? 0.0 : -wide, -0.5 * tube.liningM},
                      {side > 0 ? wide : 0.0, -0.5 * tube.liningM},
                      {side > 0 ? wide : 0.0, tube.walkwayM},
                      {side > 0 ? 0.0 : -wide, tube.walkwayM}};
    line.profileAt = [box](double) { return box; };
    addRoadLine(placed, road, line, into);
}

/// Adds two rows of lamps below the ceiling. `tube`: where its middle is.
void addLamps(const PlacedNetwork& placed, int road, const TunnelTube& shape, const RoadLine& tube,
              RoadThings& into)
{
    const Road& plain = placed.road(road);
    const double end = std::min(tube.sEnd, plain.length);
    for (double s = std::max(tube.s, 0.0) + 0.5 * kLampEveryM; s < end; s += kLampEveryM)
    {
        const double aside = 0.35 * tunnelSides(plain, s, shape).half();
        const glm::dmat3 axes = uprightAxes(placed, road, s, tube.lineT(s), 0.0);
        const glm::dvec3 middle = placed.surfacePoint(road, s, tube.lineT(s));
        for (const double side : {aside, -aside})
            into.lamps.push_back({middle + axes[1] * side + glm::dvec3(0.0, 0.0, shape.crownM - 0.22),
                                  axes[0], kLampLengthM, kLampWidthM});
    }
}

} // namespace

Profile tunnelLining(const TunnelTube& tube, double half)
{
    const double thick = tube.liningM, wide = half + thick, knee = kKnee * half + 0.5 * thick;
    return ringAround(tube, half,
                      {{wide, tube.feetM},
                       {wide, tube.wallM + 0.5 * thick},
                       {knee, tube.kneeM + thick},
                       {0.0, tube.crownM + thick},
                       {-knee, tube.kneeM + thick},
                       {-wide, tube.wallM + 0.5 * thick},
                       {-wide, tube.feetM}});
}

Profile tunnelPortal(const TunnelTube& tube, double half)
{
    const double wide = half + tube.liningM + tube.portalSideM;
    const double high = tube.crownM + tube.liningM + tube.portalRoofM;
    return ringAround(tube, half,
                      {{wide, tube.feetM},
                       {wide, high},
                       {kKnee * wide, high},
                       {0.0, high},
                       {-kKnee * wide, high},
                       {-wide, high},
                       {-wide, tube.feetM}});
}

Profile tunnelPortalBack(TunnelTube tube, double half)
{
    const double withinM = 0.5 * tube.liningM;
    tube.wallM += withinM, tube.kneeM += withinM, tube.crownM += withinM;
    tube.portalSideM -= withinM, tube.portalRoofM -= withinM;
    return tunnelPortal(tube, half + withinM);
}

void placeTunnel(const PlacedNetwork& placed, int road, const RoadStructure& tunnel, RoadThings& into)
{
    const Road& plain = placed.road(road);
    const TunnelTube shape;
    RoadLine tube = concreteLine(tunnel);
    tube.tint = {0.58F, 0.57F, 0.55F};
    tube.lineT = [&plain, shape](double s) { return tunnelSides(plain, s, shape).middle(); };
    tube.profileAt = [&plain, shape](double s)
    { return tunnelLining(shape, tunnelSides(plain, s, shape).half()); };
    tube.body = simulation::ObstacleKind::tunnelWall;
    tube.isTube = true;
    addRoadLine(placed, road, tube, into);
    addLamps(placed, road, shape, tube, into);
    for (const int side : {1, -1})
        addWalkway(placed, road, shape, side, tube, into);
    RoadLine front = tube;
    front.profileAt = [&plain, shape](double s)
    { return tunnelPortal(shape, tunnelSides(plain, s, shape).half()); };
    for (const double from : {tunnel.s - shape.portalM, tunnel.s + tunnel.length})
    {
        front.s = from;
        front.sEnd = from + shape.portalM;
        addRoadLine(placed, road, front, into);
    }
    RoadLine back = tube;
    back.profileAt = [&plain, shape](double s)
    { return tunnelPortalBack(shape, tunnelSides(plain, s, shape).half()); };
    const double backM = std::min(kPortalBackM, 0.5 * tunnel.length);
    for (const double from : {tunnel.s, tunnel.s + tunnel.length - backM})
    {
        back.s = from;
        back.sEnd = from + backM;
        if (osgRoads::core::depthInTunnel(plain, tunnel,
                                          from == tunnel.s ? tunnel.s : tunnel.s + tunnel.length) < 1.0)
            addRoadLine(placed, road, back, into); // not at the road's own end, where the tube goes on
    }
}

} // namespace scenery::roads
