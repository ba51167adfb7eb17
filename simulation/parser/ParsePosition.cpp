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
    if (reader.textOr("type", "absolute") == "relative")
        reader.context.unsupported(reader.node, "a relative Orientation");
    return {reader.optionalNumber("h"), reader.optionalNumber("p"), reader.optionalNumber("r")};
}

Position parsePosition(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("WorldPosition")) return parseWorldPosition(content);
    if (content.is("GeoPosition")) return parseGeoPosition(content);
    if (content.node)
        content.context.unsupported(content.node, std::string("the position ") + content.node.name());
    return Unsupported{content.context.line(content.node), content.node.name()};
}

} // namespace simulation
