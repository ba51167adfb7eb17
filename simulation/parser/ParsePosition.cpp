// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <foundation/Angle.h>

#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

/// One of the two angles, in the unit that its attribute's name carries.
/// A value beyond the range is refused: the commonest cause is degrees in the attribute that counts radians.
double parseAngleDeg(ElementReader& reader, const char* degrees, const char* radians, double limitDeg)
{
    const bool inRadians = !reader.has(degrees) && reader.has(radians);
    const char* const attribute = inRadians ? radians : degrees;
    const double angleDeg =
        inRadians ? foundation::degreesOf(reader.number(radians)) : reader.number(degrees);
    if (std::fabs(angleDeg) <= limitDeg * (1.0 + 1e-12)) return angleDeg;
    reader.context.invalid(reader.node, std::string("GeoPosition/") + attribute + " is out of range",
                           inRadians ? std::string(radians) + " counts radians; give degrees as " + degrees
                                     : "give degrees");
    return 0.0;
}

GeoPosition parseGeoPosition(ElementReader reader)
{
    reader.allowChildren({"Orientation"});
    GeoPosition position;
    position.source = reader.context.line(reader.node);
    position.latitudeDeg = parseAngleDeg(reader, "latitudeDeg", "latitude", 90.0);
    position.longitudeDeg = parseAngleDeg(reader, "longitudeDeg", "longitude", 180.0);
    position.heightM = reader.optionalNumber("height");
    position.altitudeM = reader.optionalNumber("altitude");
    if (const pugi::xml_node orientation = reader.node.child("Orientation"))
        position.orientation = parseOrientation({reader.context, orientation});
    return position;
}

LanePosition parseLanePosition(ElementReader reader)
{
    reader.allowChildren({"Orientation"});
    return {reader.context.line(reader.node),
            reader.text("roadId"),
            static_cast<int>(reader.number("laneId")),
            reader.number("s"),
            reader.numberOr("offset", 0.0),
            parseOrientationOf(reader)};
}

RoadPosition parseRoadPosition(ElementReader reader)
{
    reader.allowChildren({"Orientation"});
    return {reader.context.line(reader.node), reader.text("roadId"), reader.number("s"), reader.number("t"),
            parseOrientationOf(reader)};
}

RelativeLanePosition parseRelativeLanePosition(ElementReader reader)
{
    reader.allowChildren({"Orientation"});
    RelativeLanePosition position;
    position.source = reader.context.line(reader.node);
    position.entity = parseEntityRef(reader, "entityRef");
    position.lanes = static_cast<int>(reader.numberAssumed("dLane", 0.0));
    position.isAlongLane = reader.has("dsLane");
    position.dsM = position.isAlongLane ? reader.number("dsLane") : reader.numberAssumed("ds", 0.0);
    position.offsetM = reader.numberOr("offset", 0.0);
    position.orientation = parseOrientationOf(reader);
    return position;
}

RelativeRoadPosition parseRelativeRoadPosition(ElementReader reader)
{
    reader.allowChildren({"Orientation"});
    return {reader.context.line(reader.node), parseEntityRef(reader, "entityRef"),
            reader.numberAssumed("ds", 0.0), reader.numberAssumed("dt", 0.0), parseOrientationOf(reader)};
}

/// RelativeObjectPosition and RelativeWorldPosition.
template<class Relative>
Relative parseRelativePosition(ElementReader reader)
{
    reader.allowChildren({"Orientation"});
    return {reader.context.line(reader.node), parseEntityRef(reader, "entityRef"),
            reader.numberAssumed("dx", 0.0),  reader.numberAssumed("dy", 0.0),
            reader.numberOr("dz", 0.0),       parseOrientationOf(reader)};
}

WorldPosition parseWorldPosition(ElementReader reader)
{
    reader.allowChildren({});
    WorldPosition position;
    position.source = reader.context.line(reader.node);
    position.xM = reader.number("x");
    position.yM = reader.number("y");
    position.zM = reader.optionalNumber("z");
    position.orientation = {reader.optionalNumber("h"), reader.optionalNumber("p"),
                            reader.optionalNumber("r")};
    return position;
}

} // namespace

Orientation parseOrientation(ElementReader reader)
{
    return {reader.optionalNumber("h"), reader.optionalNumber("p"), reader.optionalNumber("r"),
            reader.textOr("type", "absolute") == "relative"};
}

Orientation parseOrientationOf(ElementReader position)
{
    const pugi::xml_node node = position.node.child("Orientation");
    if (!node) return {.headingRad = {}, .pitchRad = {}, .rollRad = {}, .isRelative = true};
    return parseOrientation({position.context, node});
}

Position parsePosition(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("WorldPosition")) return parseWorldPosition(content);
    if (content.is("GeoPosition")) return parseGeoPosition(content);
    if (content.is("LanePosition")) return parseLanePosition(content);
    if (content.is("RoadPosition")) return parseRoadPosition(content);
    if (content.is("RelativeLanePosition")) return parseRelativeLanePosition(content);
    if (content.is("RelativeRoadPosition")) return parseRelativeRoadPosition(content);
    if (content.is("RelativeObjectPosition")) return parseRelativePosition<RelativeObjectPosition>(content);
    if (content.is("RelativeWorldPosition")) return parseRelativePosition<RelativeWorldPosition>(content);
    if (content.is("RoutePosition")) return parseRoutePosition(content);
    if (content.is("TrajectoryPosition")) return parseTrajectoryPosition(content);
    return unsupportedContent(content, "position");
}

} // namespace simulation
