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

std::vector<std::optional<double>> timesOf(const TrajectoryShape& shape)
{
    std::vector<std::optional<double>> times;
    if (const auto* clothoid = std::get_if<Clothoid>(&shape))
        times = {clothoid->startTimeS, clothoid->stopTimeS};
    if (const auto* spline = std::get_if<ClothoidSpline>(&shape))
    {
        for (const ClothoidSpline::Segment& segment : spline->segments)
            times.push_back(segment.timeStartS);
        times.push_back(spline->timeEndS);
    }
    if (const auto* nurbs = std::get_if<Nurbs>(&shape))
        for (const Nurbs::ControlPoint& point : nurbs->points)
            times.push_back(point.timeS);
    return times;
}

/// Names a time of a shape for a message.
std::string nameOfTime(const TrajectoryShape& shape, std::size_t index)
{
    if (std::holds_alternative<Clothoid>(shape)) return index == 0 ? "startTime" : "stopTime";
    if (const auto* spline = std::get_if<ClothoidSpline>(&shape))
        return index < spline->segments.size() ? "the timeStart of segment " + std::to_string(index + 1)
                                               : "timeEnd";
    return "the time of control point " + std::to_string(index + 1);
}

void checkVertexTimes(ParseContext& context, pugi::xml_node holder, const Polyline& polyline)
{
    for (std::size_t i = 0; i < polyline.vertices.size(); ++i)
    {
        const std::optional<double>& time = polyline.vertices[i].timeS;
        const std::string vertex = "vertex " + std::to_string(i + 1) + " (line " +
                                   std::to_string(polyline.vertices[i].source.line) + ")";
        if (!time)
            context.invalid(holder, vertex + " has no time, but the trajectory has a Timing", "add its time");
        else if (i > 0 && !Vertex::isLater(polyline.vertices[i - 1].timeS.value_or(*time - 1.0), *time))
            context.invalid(holder, "the time of " + vertex + " is not later than the one before",
                            "order the vertices");
        else
            continue;
        return;
    }
}

} // namespace

void checkShapeTimes(ParseContext& context, pugi::xml_node holder, const TrajectoryShape& shape)
{
    if (const auto* polyline = std::get_if<Polyline>(&shape))
    {
        checkVertexTimes(context, holder, *polyline);
        return;
    }
    const std::vector<std::optional<double>> times = timesOf(shape);
    for (std::size_t i = 0; i < times.size(); ++i)
    {
        if (!times[i])
            context.invalid(holder, nameOfTime(shape, i) + " is missing, but the trajectory has a Timing",
                            "add it");
        else if (i > 0 && !Vertex::isLater(*times[i - 1], *times[i]))
            context.invalid(holder, nameOfTime(shape, i) + " is not later than the one before",
                            "let times rise");
        else
            continue;
        return;
    }
}

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
