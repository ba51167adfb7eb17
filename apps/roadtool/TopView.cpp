// SPDX-License-Identifier: Apache-2.0
#include "roadtool/TopView.h"

#include <algorithm>

#include "roadtool/Palette.h"
#include "roadtool/RoadPainter.h"

namespace roadtool
{

namespace
{

using namespace osgRoads::core;

constexpr double kMostSamples = 1e6;

} // namespace

PlanBox boundsOf(const RoadNetwork& network)
{
    PlanBox bounds;
    for (const Road& road : network.roads)
    {
        if (!road.isUsable) continue;
        for (const PlanElement& element : road.referenceLine.elements())
            for (const double share : {0.0, 0.5, 1.0})
                bounds.include(element.at(element.length * share).position);
    }
    return bounds;
}

TopView topView(const RoadNetwork& network)
{
    TopView view;
    view.background = kGround;
    const double shortestM = network.usableLengthM() / kMostSamples;
    const auto paint = [&](bool isJunction, auto part)
    {
        for (const Road& road : network.roads)
            if (road.isUsable && (road.junction >= 0) == isJunction) part(road, shortestM, view.polygons);
    };
    for (const auto part : {paintLanes, paintMarks, paintObjects})
        for (const bool isJunction : {true, false})
            paint(isJunction, part);
    for (const FilledPolygon& polygon : view.polygons)
        for (const glm::dvec2 corner : polygon.corners)
            view.bounds.include(corner);
    if (view.polygons.empty()) view.bounds = boundsOf(network);
    const double margin = 0.02 * std::max({view.bounds.most.x - view.bounds.least.x,
                                           view.bounds.most.y - view.bounds.least.y, 1.0});
    view.bounds.least -= glm::dvec2(margin, margin);
    view.bounds.most += glm::dvec2(margin, margin);
    return view;
}

} // namespace roadtool
