// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/ObjectInstances.h>
#include <osgRoads/core/surface/Decal.h>

#include "DecalMaker.h"
#include "ExplicitMarks.h"
#include "Markings.h"

namespace osgRoads::core
{

namespace
{

constexpr double kStopWidthM = 0.5, kYieldDashM = 0.5, kYieldPeriodM = 0.75;
constexpr double kStripeM = 0.5, kCrosswalkM = 4.0, kSpaceLineM = 0.12;
constexpr glm::vec3 kPatchPaint{0.055F, 0.055F, 0.057F};

double orElse(double value, double otherwise)
{
    return value > 0.0 ? value : otherwise;
}

struct Reach
{
    double right = 0.0, left = 0.0;
};

/// The t between which a line across the road lies.
Reach reachOf(const Road& road, const RoadItem& item, double width, double t)
{
    Reach reach{1e9, -1e9};
    for (const LaneValidity& validity : item.validities)
        for (int lane = std::min(validity.fromLane, validity.toLane);
             lane <= std::max(validity.fromLane, validity.toLane); ++lane)
            if (const auto span = laneSpan(road, lane, item.s); span && isForCars(span->lane->type))
            {
                reach.right = std::min({reach.right, span->innerT, span->outerT});
                reach.left = std::max({reach.left, span->innerT, span->outerT});
            }
    if (reach.right < reach.left) return reach;
    reach = {t - 0.5 * width, t + 0.5 * width};
    const double middle = road.laneOffset.value(item.s);
    if (item.orientation == '0' || reach.right >= middle || reach.left <= middle) return reach;
    const bool isOnLeft = (item.orientation == '-') != road.isLeftHandTraffic;
    return isOnLeft ? Reach{middle, middle + width} : Reach{middle - width, middle};
}

void addLineAcross(const PlacedNetwork& network, int road, const RoadItem& item, PaintKind kind,
                   std::vector<Decal>& into)
{
    const RoadExtent lanes = extentAt(network.road(road), item.s);
    const Reach reach =
        reachOf(network.road(road), item, orElse(item.width, lanes.leftT - lanes.rightT), item.t);
    DecalMaker maker(network, road, item.s, 0.0, 0.0, into);
    if (kind == PaintKind::yieldLine)
        maker.stripedBar({0.0, reach.right}, {0.0, reach.left}, kStopWidthM, kYieldDashM, kYieldPeriodM);
    else
        maker.bar({0.0, reach.right}, {0.0, reach.left}, kStopWidthM);
}

double turnOf(const RoadItem& item)
{
    return item.orientation == '-' ? std::numbers::pi : 0.0;
}

void addSignal(const PlacedNetwork& network, int road, const Signal& signal, std::vector<Decal>& into)
{
    const auto kind = paintKind(signal);
    if (!kind) return;
    if (*kind == PaintKind::stopLine || *kind == PaintKind::yieldLine)
        return addLineAcross(network, road, signal, *kind, into);
    DecalMaker maker(network, road, signal.s, signal.t, turnOf(signal), into);
    if (*kind == PaintKind::arrow) return maker.arrow(arrowHeads(signal), 1.0);
    const double half =
        0.5 * orElse(signal.width, 2.0 * std::max(extentAt(network.road(road), signal.s).leftT, 3.0));
    maker.stripedBar({0.0, -half}, {0.0, half}, orElse(signal.value.value_or(0.0), kCrosswalkM), kStripeM,
                     2.0 * kStripeM);
}

/// The corners of an object in its own frame: of its outer outline, else of its length and width.
std::vector<glm::dvec2> cornersOf(const RoadObject& object, const ObjectInstance& instance,
                                  const DecalMaker& maker)
{
    std::vector<glm::dvec2> corners;
    for (const ObjectOutline& outline : object.outlines)
    {
        if (!outline.isOuter || outline.corners.size() < 3) continue;
        for (const OutlineCorner& corner : outline.corners)
            corners.push_back(maker.cornerOf(corner));
        return corners;
    }
    const double u = 0.5 * instance.length, v = 0.5 * instance.width;
    if (u > 0.0 && v > 0.0) corners = {{-u, -v}, {u, -v}, {u, v}, {-u, v}};
    return corners;
}

/// The lines around a parking space; the side nearest to the middle of the road stays open.
void addParkingSpace(const std::vector<glm::dvec2>& corners, double t, double headingRad, DecalMaker& maker)
{
    // t grows along this direction of the object's frame.
    const glm::dvec2 left(std::sin(headingRad), std::cos(headingRad));
    std::size_t open = 0;
    double nearest = 1e300;
    const auto next = [&](std::size_t i) { return corners[(i + 1) % corners.size()]; };
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const double distance = std::fabs(t + glm::dot(left, 0.5 * (corners[i] + next(i))));
        if (distance < nearest) open = i;
        nearest = std::min(nearest, distance);
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (i != open) maker.bar(corners[i], next(i), kSpaceLineM);
}

void addObject(const PlacedNetwork& network, int road, const RoadObject& object, std::vector<Decal>& into)
{
    addMarkings(network, road, object, into);
    const auto kind = paintKind(object);
    if (!kind || (*kind == PaintKind::parkingSpace && !object.markings.empty())) return;
    if (*kind == PaintKind::stopLine || *kind == PaintKind::yieldLine)
        return addLineAcross(network, road, object, *kind, into);
    for (const ObjectInstance& instance : objectInstances(object))
    {
        if (instance.isStretch) continue;
        const double heading = instance.headingRad + (*kind == PaintKind::arrow ? turnOf(object) : 0.0);
        DecalMaker maker(network, road, instance.s, instance.t, heading, into);
        if (*kind == PaintKind::arrow)
        {
            maker.arrow(arrowHeads(object), orElse(instance.length, 5.0) / 5.0);
            continue;
        }
        const std::vector<glm::dvec2> corners = cornersOf(object, instance, maker);
        if (corners.size() < 3) continue;
        if (*kind == PaintKind::parkingSpace)
            addParkingSpace(corners, instance.t, heading, maker);
        else if (*kind == PaintKind::crosswalk)
            maker.area(corners, {std::sin(heading), std::cos(heading)}, kStripeM, 2.0 * kStripeM);
        else
        {
            if (*kind == PaintKind::patch) maker.setPaint(kPatchPaint);
            maker.area(corners, {1.0, 0.0}, 0.0, 0.0);
        }
    }
}

} // namespace

std::vector<Decal> roadDecals(const PlacedNetwork& network)
{
    std::vector<Decal> decals;
    for (int i = 0; i < static_cast<int>(network.network().roads.size()); ++i)
    {
        const Road& road = network.road(i);
        if (!road.isUsable) continue;
        addExplicitMarks(network, i, decals);
        for (const Signal& signal : road.signals)
            addSignal(network, i, signal, decals);
        for (const RoadObject& object : road.objects)
            addObject(network, i, object, decals);
    }
    return decals;
}

} // namespace osgRoads::core
