// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "scenery/roads/things/StructureParts.h"
#include "scenery/roads/things/ThingPose.h"

namespace scenery::roads
{

namespace
{

using osgRoads::core::LaneSpan;
using osgRoads::core::LaneType;
using osgRoads::core::PlacedNetwork;
using osgRoads::core::Road;
using osgRoads::core::RoadStructure;

/// Inside: clearance of 4.5 m and above (German RABT, Richtlinien für die Ausstattung und den Betrieb von Straßentunneln, 2006).
constexpr double kHighM = 6.2, kWallM = 4.6, kLiningM = 0.6, kBesideM = 1.0, kFeetM = -0.6;
constexpr double kPortalM = 0.8, kPortalSideM = 1.8, kPortalRoofM = 1.4; ///< thickness; beyond the tube
constexpr double kLampEveryM = 10.0, kLampLengthM = 1.6, kLampWidthM = 0.35;

/// The sides of the paved lanes: what a file has beside them as `none` lies outside.
Sides pavedSides(const Road& road, double s)
{
    const double middle = road.laneOffset.value(s);
    Sides sides{middle, middle};
    const osgRoads::core::LaneSection* section = osgRoads::core::sectionAt(road, s);
    if (section)
        for (const int sign : {1, -1})
            osgRoads::core::forLanesOutwards(road, *section, sign, s,
                                             [&](const LaneSpan& span)
                                             {
                                                 if (span.lane->type != LaneType::none)
                                                     (sign > 0 ? sides.left : sides.right) = span.outerT;
                                                 return true;
                                             });
    return {sides.left + kBesideM, sides.right - kBesideM};
}

/// A ring around the inside of the tube, from the right foot over the crown to the left one and back.
Profile ringAround(double half, Profile outside)
{
    const Profile inside{{-half, kFeetM},
                         {-half, kWallM},
                         {-0.6 * half, kHighM - 0.3},
                         {0.0, kHighM},
                         {0.6 * half, kHighM - 0.3},
                         {half, kWallM},
                         {half, kFeetM}};
    outside.insert(outside.end(), inside.begin(), inside.end()); // outside counter-clockwise, inside back
    return outside;
}

Profile lining(double half)
{
    const double wide = half + kLiningM, high = kHighM + kLiningM, knee = 0.6 * half + 0.3;
    return ringAround(half, {{wide, kFeetM},
                             {wide, kWallM + 0.3},
                             {knee, high - 0.3},
                             {0.0, high},
                             {-knee, high - 0.3},
                             {-wide, kWallM + 0.3},
                             {-wide, kFeetM}});
}

/// The front of a portal: a wall with level top around the mouth.
Profile portal(double half)
{
    const double wide = half + kLiningM + kPortalSideM, high = kHighM + kLiningM + kPortalRoofM;
    return ringAround(half, {{wide, kFeetM - 2.0},
                             {wide, high},
                             {0.6 * wide, high},
                             {0.0, high},
                             {-0.6 * wide, high},
                             {-wide, high},
                             {-wide, kFeetM - 2.0}});
}

/// Adds two rows of lamps below the ceiling. `tube`: where its middle is.
void addLamps(const PlacedNetwork& placed, int road, const RoadLine& tube, RoadThings& into)
{
    const Road& plain = placed.road(road);
    const double end = std::min(tube.sEnd, plain.length);
    for (double s = std::max(tube.s, 0.0) + 0.5 * kLampEveryM; s < end; s += kLampEveryM)
    {
        const double aside = 0.35 * pavedSides(plain, s).half();
        const glm::dmat3 axes = uprightAxes(placed, road, s, tube.lineT(s), 0.0);
        const glm::dvec3 middle = placed.surfacePoint(road, s, tube.lineT(s));
        for (const double side : {aside, -aside})
            into.lamps.push_back({middle + axes[1] * side + glm::dvec3(0.0, 0.0, kHighM - 0.22), axes[0],
                                  kLampLengthM, kLampWidthM});
    }
}

} // namespace

void placeTunnel(const PlacedNetwork& placed, int road, const RoadStructure& tunnel, RoadThings& into)
{
    const Road& plain = placed.road(road);
    RoadLine tube = concreteLine(tunnel);
    tube.tint = {0.58F, 0.57F, 0.55F};
    tube.lineT = [&plain](double s) { return pavedSides(plain, s).middle(); };
    tube.profileAt = [&plain](double s) { return lining(pavedSides(plain, s).half()); };
    addRoadLine(placed, road, tube, into);
    addLamps(placed, road, tube, into);
    RoadLine front = tube;
    front.profileAt = [&plain](double s) { return portal(pavedSides(plain, s).half()); };
    for (const double from : {tunnel.s - kPortalM, tunnel.s + tunnel.length})
    {
        front.s = from;
        front.sEnd = from + kPortalM;
        addRoadLine(placed, road, front, into);
    }
}

} // namespace scenery::roads
