// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/CatalogShelf.h"
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

FixedPosition parseWaypoint(ElementReader reader)
{
    ElementReader holder = reader.child("Position");
    const Position position = parsePosition(holder);
    if (const auto* world = std::get_if<WorldPosition>(&position)) return *world;
    if (const auto* geo = std::get_if<GeoPosition>(&position)) return *geo;
    if (const auto* lane = std::get_if<LanePosition>(&position)) return *lane;
    if (const auto* road = std::get_if<RoadPosition>(&position)) return *road;
    if (const auto* unknown = std::get_if<Unsupported>(&position)) return *unknown;
    reader.context.unsupported(holder.node, "a Waypoint that refers to an entity or a route",
                               "it is left out");
    return Unsupported{reader.context.line(reader.node), "Waypoint"};
}

Route parseRoute(ElementReader reader)
{
    reader.allowChildren({"ParameterDeclarations", "Waypoint"});
    const ParameterScope scope(reader.context, reader.node);
    Route route;
    route.source = reader.context.line(reader.node);
    route.name = reader.name();
    route.closed = reader.flagOr("closed", false);
    for (pugi::xml_node node : reader.node.children("Waypoint"))
    {
        ElementReader waypoint(reader.context, node);
        route.strategies.push_back(
            waypoint.choiceOr("routeStrategy", kRouteStrategies, RouteStrategy::shortest));
        route.waypoints.push_back(parseWaypoint(waypoint));
    }
    if (route.waypoints.empty()) reader.context.invalid(reader.node, "a Route has no Waypoint", "add two");
    return route;
}

} // namespace

Route parseRouteIn(ElementReader holder)
{
    if (const pugi::xml_node reference = holder.node.child("CatalogReference"))
    {
        CatalogVisit visit({holder.context, reference});
        return visit.entry() ? parseRoute({holder.context, visit.entry()}) : Route{};
    }
    return parseRoute(holder.child("Route"));
}

RoutePosition parseRoutePosition(ElementReader reader)
{
    reader.allowChildren({"Orientation", "RouteRef", "InRoutePosition"});
    RoutePosition position;
    position.source = reader.context.line(reader.node);
    position.orientation = parseOrientationOf(reader);
    position.route = parseRouteIn(reader.child("RouteRef"));
    ElementReader place = reader.child("InRoutePosition").onlyChild();
    if (place.is("FromCurrentEntity"))
    {
        position.entity = parseEntityRef(place, "entityRef");
        return position;
    }
    if (place.is("FromLaneCoordinates"))
    {
        position.lane = static_cast<int>(place.number("laneId"));
        position.offsetM = place.numberOr("laneOffset", 0.0);
    }
    else if (place.is("FromRoadCoordinates"))
        position.offsetM = place.number("t");
    else
    {
        unsupportedContent(place, "element");
        return position;
    }
    position.pathM = place.notNegative("pathS");
    return position;
}

} // namespace simulation
