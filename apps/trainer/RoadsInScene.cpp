// SPDX-License-Identifier: Apache-2.0
#include "RoadsInScene.h"

#include <cmath>
#include <utility>
#include <vector>

namespace trainer
{

namespace
{

using osgRoads::core::Cubic;
using osgRoads::core::CubicProfile;
using osgRoads::core::PlacedNetwork;
using osgRoads::core::PlanElement;
using osgRoads::core::Road;

double angleOf(const glm::dvec2& way)
{
    return std::atan2(way.y, way.x);
}

glm::dvec2 turned(const glm::dvec2& way, double angleRad)
{
    const double c = std::cos(angleRad), s = std::sin(angleRad);
    return {c * way.x - s * way.y, s * way.x + c * way.y};
}

/// Adds a straight line to a profile.
CubicProfile raised(const CubicProfile& profile, double byM, double slope)
{
    std::vector<Cubic> pieces = profile.pieces();
    if (pieces.empty()) pieces.push_back({});
    for (Cubic& piece : pieces)
    {
        piece.a += byM + slope * piece.s;
        piece.b += slope;
    }
    return CubicProfile(std::move(pieces));
}

void move(const PlacedNetwork& roads, int index, Road& road)
{
    const glm::dvec3 start = roads.point({index, 0.0, 0.0, 0.0}),
                     end = roads.point({index, road.length, 0.0, 0.0});
    const glm::dvec2 from = road.referenceLine.at(0.0).position,
                     to = road.referenceLine.at(road.length).position;
    glm::dvec2 way = to - from, placedWay = glm::dvec2(end - start);
    if (glm::length(way) < 1.0) // a ring: a piece of it tells its direction
    {
        const double s = 0.25 * road.length;
        way = road.referenceLine.at(s).position - from;
        placedWay = glm::dvec2(roads.point({index, s, 0.0, 0.0}) - start);
    }
    const double turnRad = angleOf(placedWay) - angleOf(way);
    std::vector<PlanElement> elements;
    for (const PlanElement& element : road.referenceLine.elements())
    {
        const auto point = element.at(0.0);
        elements.emplace_back(element.s, element.length,
                              glm::dvec2(start) + turned(point.position - from, turnRad),
                              point.headingRad + turnRad, element.shape());
    }
    road.referenceLine = osgRoads::core::ReferenceLine(std::move(elements));
    const double startM = start.z - road.elevation.value(0.0),
                 endM = end.z - road.elevation.value(road.length);
    road.elevation = raised(road.elevation, startM, (endM - startM) / road.length);
}

} // namespace

osgRoads::core::RoadNetwork roadsInScene(const PlacedNetwork& roads)
{
    osgRoads::core::RoadNetwork network = roads.network();
    for (std::size_t i = 0; i < network.roads.size(); ++i)
        if (network.roads[i].isUsable && network.roads[i].length > 0.0)
            move(roads, static_cast<int>(i), network.roads[i]);
    network.header.geoReference.clear();
    network.header.offsetX = network.header.offsetY = network.header.offsetZ =
        network.header.offsetHeadingRad = 0.0;
    return network;
}

} // namespace trainer
