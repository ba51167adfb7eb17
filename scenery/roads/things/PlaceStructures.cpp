// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgRoads/core/query/LaneSpan.h>

#include "scenery/roads/things/Placers.h"
#include "scenery/roads/things/RoadLine.h"

namespace scenery::roads
{

namespace
{

using osgRoads::core::PlacedNetwork;
using osgRoads::core::RoadStructure;

constexpr double kDeckM = 1.2, kParapetM = 1.1, kParapetWidthM = 0.25,
                 kSideM = 0.5; ///< bridge: thickness, parapets, beyond the lanes
constexpr double kPierEveryM = 30.0, kPierRadiusM = 0.6;
constexpr double kTunnelHighM = 6.2, kTunnelWallM = 4.6, kLiningM = 0.6,
                 kTunnelSideM = 1.0; ///< inside; clearance 4.5 m and above (RABT)

struct Sides
{
    double left, right;
    double middle() const { return 0.5 * (left + right); }
    double half() const { return 0.5 * (left - right); }
};

Sides sidesAt(const osgRoads::core::Road& road, double s, double beyondM)
{
    const auto extent = osgRoads::core::extentAt(road, s);
    return {extent.leftT + beyondM, extent.rightT - beyondM};
}

RoadLine concrete(const RoadStructure& structure)
{
    RoadLine line;
    line.s = structure.s;
    line.sEnd = structure.s + structure.length;
    line.surface = {models::Painting::plaster, models::Coat::matt};
    line.tint = {0.62F, 0.61F, 0.58F};
    line.uvPerM = 1.0 / 2.4;
    return line;
}

void addPiers(const PlacedNetwork& placed, int road, const RoadStructure& bridge, const GroundHeight& ground,
              RoadThings& into)
{
    for (double along = 0.5 * kPierEveryM; along < bridge.length; along += kPierEveryM)
    {
        const double s = bridge.s + along;
        const glm::dvec3 top = placed.surfacePoint(road, s, sidesAt(placed.road(road), s, 0.0).middle());
        const auto height = ground ? ground(top.x, top.y) : std::nullopt;
        if (!height || top.z - kDeckM - *height < 1.5) continue;
        const double depth = top.z - *height + 1.0;
        RoadLine pier = concrete(bridge);
        pier.s = s - kPierRadiusM;
        pier.sEnd = s + kPierRadiusM;
        pier.lineT = [&, s](double) { return sidesAt(placed.road(road), s, 0.0).middle(); };
        const double half = 0.6 * sidesAt(placed.road(road), s, 0.0).half();
        pier.profileAt = [=](double) {
            return Profile{{-half, -depth}, {half, -depth}, {half, -0.9 * kDeckM}, {-half, -0.9 * kDeckM}};
        };
        addRoadLine(placed, road, pier, into);
    }
}

void addBridge(const PlacedNetwork& placed, int road, const RoadStructure& bridge, const GroundHeight& ground,
               RoadThings& into)
{
    const auto& plain = placed.road(road);
    // Below the surface by 5 cm, so that the deck never fights the road for depth. The road's tilt is that of its edges.
    for (const int side : {1, -1})
    {
        RoadLine parapet = concrete(bridge);
        parapet.lineT = [&plain, side](double s)
        {
            const Sides sides = sidesAt(plain, s, kSideM);
            return side > 0 ? sides.left : sides.right;
        };
        parapet.profileAt = [](double)
        {
            return Profile{{-0.5 * kParapetWidthM, -kDeckM},
                           {0.5 * kParapetWidthM, -kDeckM},
                           {0.5 * kParapetWidthM, kParapetM},
                           {-0.5 * kParapetWidthM, kParapetM}};
        };
        addRoadLine(placed, road, parapet, into);
    }
    RoadLine deck = concrete(bridge);
    deck.lineT = [&plain](double s) { return sidesAt(plain, s, kSideM).middle(); };
    deck.profileAt = [&placed, &plain, road](double s)
    {
        const Sides sides = sidesAt(plain, s, kSideM);
        const double tilt = 0.5 * (placed.surfacePoint(road, s, sides.left).z -
                                   placed.surfacePoint(road, s, sides.right).z),
                     half = sides.half();
        return Profile{
            {-half, -kDeckM - tilt}, {half, -kDeckM + tilt}, {half, -0.05 + tilt}, {-half, -0.05 - tilt}};
    };
    addRoadLine(placed, road, deck, into);
    addPiers(placed, road, bridge, ground, into);
}

/// Half a lining: a strip of the inner and the outer side, from the right foot over the crown to the left one.
Profile lining(double half)
{
    const double feet = -0.6;
    const Profile inner{{-half, feet},
                        {-half, kTunnelWallM},
                        {-0.6 * half, kTunnelHighM - 0.3},
                        {0.0, kTunnelHighM},
                        {0.6 * half, kTunnelHighM - 0.3},
                        {half, kTunnelWallM},
                        {half, feet}};
    const double wide = half + kLiningM, high = kTunnelHighM + kLiningM;
    Profile ring{{wide, feet}, {wide, kTunnelWallM + 0.3},      {0.6 * half + 0.3, high - 0.3},
                 {0.0, high},  {-0.6 * half - 0.3, high - 0.3}, {-wide, kTunnelWallM + 0.3},
                 {-wide, feet}};
    ring.insert(ring.end(), inner.begin(), inner.end()); // outside counter-clockwise, inside back
    return ring;
}

void addTunnel(const PlacedNetwork& placed, int road, const RoadStructure& tunnel, RoadThings& into)
{
    const auto& plain = placed.road(road);
    RoadLine tube = concrete(tunnel);
    tube.tint = {0.58F, 0.57F, 0.55F};
    tube.lineT = [&plain](double s) { return sidesAt(plain, s, kTunnelSideM).middle(); };
    tube.profileAt = [&plain](double s) { return lining(sidesAt(plain, s, kTunnelSideM).half()); };
    addRoadLine(placed, road, tube, into);
    RoadLine lamps = tube;
    lamps.surface = models::kRoadSigns;
    lamps.uvPerM = 0.0;
    lamps.tint = {1.0F, 0.98F, 0.9F};
    lamps.profileAt = [](double)
    {
        return Profile{{-0.15, kTunnelHighM - 0.2},
                       {0.15, kTunnelHighM - 0.2},
                       {0.15, kTunnelHighM - 0.1},
                       {-0.15, kTunnelHighM - 0.1}};
    };
    addRoadLine(placed, road, lamps, into);
}

} // namespace

void placeStructures(const PlacedNetwork& placed, int road, const GroundHeight& ground, RoadThings& into)
{
    for (const RoadStructure& structure : placed.road(road).structures)
        if (structure.kind == osgRoads::core::StructureKind::bridge)
            addBridge(placed, road, structure, ground, into);
        else
            addTunnel(placed, road, structure, into);
}

RoadThings placeRoadThings(const PlacedNetwork& placed, const GroundHeight& ground)
{
    RoadThings things;
    for (int road = 0; road < static_cast<int>(placed.network().roads.size()); ++road)
    {
        if (!placed.road(road).isUsable) continue;
        placeSignals(placed, road, things);
        placeObjects(placed, road, ground, things);
        placeStructures(placed, road, ground, things);
    }
    return things;
}

} // namespace scenery::roads
