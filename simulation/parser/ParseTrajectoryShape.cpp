// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenSCENARIO XML 1.3, Shape; 1.0 for Clothoid/curvatureDot.
#include <algorithm>

#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

Polyline parsePolyline(ElementReader reader)
{
    reader.allowChildren({"Vertex"});
    ParseContext& context = reader.context;
    Polyline polyline;
    polyline.source = context.line(reader.node);
    for (pugi::xml_node node : reader.node.children("Vertex"))
    {
        if (context.isStopped()) break;
        ElementReader vertex(context, node);
        vertex.allowChildren({"Position"});
        polyline.vertices.push_back(
            {context.line(node), vertex.optionalNumber("time"), parsePosition(vertex.child("Position"))});
    }
    if (polyline.vertices.size() < 2)
        context.invalid(reader.node, "a Polyline needs two vertices", "add vertices");
    return polyline;
}

/// A length that something can be driven along.
double parseLength(ElementReader& reader)
{
    const double length = reader.number("length");
    if (length > 0.0) return length;
    reader.context.invalid(reader.node, std::string(reader.node.name()) + "/length is not above 0",
                           "give metres");
    return 1.0;
}

Clothoid parseClothoid(ElementReader reader)
{
    reader.allowChildren({"Position"});
    Clothoid clothoid;
    clothoid.source = reader.context.line(reader.node);
    clothoid.curvature = reader.number("curvature");
    clothoid.curvaturePrime =
        reader.has("curvatureDot") ? reader.number("curvatureDot") : reader.number("curvaturePrime");
    clothoid.lengthM = parseLength(reader);
    clothoid.startTimeS = reader.optionalNumber("startTime");
    clothoid.stopTimeS = reader.optionalNumber("stopTime");
    clothoid.start = parsePosition(reader.child("Position"));
    return clothoid;
}

ClothoidSpline parseClothoidSpline(ElementReader reader)
{
    reader.allowChildren({"ClothoidSplineSegment"});
    ClothoidSpline spline;
    spline.source = reader.context.line(reader.node);
    spline.timeEndS = reader.optionalNumber("timeEnd");
    for (pugi::xml_node node : reader.node.children("ClothoidSplineSegment"))
    {
        ElementReader content(reader.context, node);
        content.allowChildren({"PositionStart"});
        ClothoidSpline::Segment segment;
        segment.curvatureStart = content.number("curvatureStart");
        segment.curvatureEnd = content.number("curvatureEnd");
        segment.lengthM = parseLength(content);
        segment.headingOffsetRad = content.numberOr("hOffset", 0.0);
        segment.timeStartS = content.optionalNumber("timeStart");
        if (node.child("PositionStart")) segment.start = parsePosition(content.child("PositionStart"));
        spline.segments.push_back(std::move(segment));
    }
    if (spline.segments.empty())
        reader.context.invalid(reader.node, "a ClothoidSpline has no segment", "add one");
    return spline;
}

/// The first thing about points and knots that no curve can have; empty: nothing.
std::string mistakeOf(const Nurbs& nurbs)
{
    const std::size_t points = nurbs.points.size();
    const auto order = static_cast<std::size_t>(nurbs.order);
    if (points < order) return "has fewer control points than its order";
    if (nurbs.knots.size() != points + order)
        return "has " + std::to_string(nurbs.knots.size()) + " knots, not " + std::to_string(points + order);
    if (!std::is_sorted(nurbs.knots.begin(), nurbs.knots.end())) return "has knots that fall";
    if (!(nurbs.knots[points] > nurbs.knots[order - 1])) return "has knots without an interval";
    return {};
}

Nurbs parseNurbs(ElementReader reader)
{
    constexpr int kHighestOrder = 20;
    reader.allowChildren({"ControlPoint", "Knot"});
    Nurbs nurbs;
    nurbs.source = reader.context.line(reader.node);
    nurbs.order = reader.count("order", 2);
    if (nurbs.order < 2 || nurbs.order > kHighestOrder)
    {
        reader.context.invalid(reader.node, "Nurbs/order is not within 2 and 20", "use 4 for a cubic curve");
        nurbs.order = 2;
    }
    for (pugi::xml_node node : reader.node.children("ControlPoint"))
    {
        ElementReader content(reader.context, node);
        content.allowChildren({"Position"});
        Nurbs::ControlPoint point{content.optionalNumber("time"), content.numberOr("weight", 1.0),
                                  parsePosition(content.child("Position"))};
        if (!(point.weight > 0.0))
        {
            reader.context.invalid(node, "ControlPoint/weight is not above 0", "use 1");
            point.weight = 1.0;
        }
        nurbs.points.push_back(std::move(point));
    }
    for (pugi::xml_node node : reader.node.children("Knot"))
        nurbs.knots.push_back(ElementReader(reader.context, node).number("value"));
    if (const std::string mistake = mistakeOf(nurbs); !mistake.empty())
        reader.context.invalid(reader.node, "the Nurbs " + mistake,
                               "give as many knots as control points plus order, none below the one before");
    return nurbs;
}

} // namespace

TrajectoryShape parseTrajectoryShape(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("Polyline")) return parsePolyline(content);
    if (content.is("Clothoid")) return parseClothoid(content);
    if (content.is("ClothoidSpline")) return parseClothoidSpline(content);
    if (content.is("Nurbs")) return parseNurbs(content);
    if (content.node) content.context.foreign(content.node, std::string("the shape ") + content.node.name());
    return Unsupported{content.context.line(content.node), content.node.name()};
}

} // namespace simulation
