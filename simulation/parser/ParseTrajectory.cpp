// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/CatalogShelf.h"
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

TrajectoryShape parseShape(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("Polyline")) return parsePolyline(content);
    if (content.node) content.context.foreign(content.node, std::string("the shape ") + content.node.name());
    return Unsupported{content.context.line(content.node), content.node.name()};
}

std::optional<Timing> parseTimeReference(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (!content.is("Timing"))
    {
        if (content.node && !content.is("None"))
            content.context.foreign(content.node, std::string("the element ") + content.node.name());
        return std::nullopt;
    }
    Timing timing{content.choice("domainAbsoluteRelative", kTimingDomains), content.number("scale"),
                  content.number("offset")};
    if (!Timing::isScale(timing.scale))
        content.context.invalid(content.node, "Timing/scale is not within 1e-6 and 1e6", "use 1");
    return timing;
}

/// Times must rise, in a trajectory that is played by them.
void checkTimes(ParseContext& context, pugi::xml_node node, const Trajectory& trajectory)
{
    const auto* polyline = std::get_if<Polyline>(&trajectory.shape);
    if (!polyline) return;
    for (std::size_t i = 0; i < polyline->vertices.size(); ++i)
    {
        const std::optional<double>& time = polyline->vertices[i].timeS;
        const std::string vertex = "vertex " + std::to_string(i + 1) + " (line " +
                                   std::to_string(polyline->vertices[i].source.line) + ")";
        if (!time)
            context.invalid(node, vertex + " has no time, but the trajectory has a Timing", "add its time");
        else if (i > 0 && !Vertex::isLater(polyline->vertices[i - 1].timeS.value_or(*time - 1.0), *time))
            context.invalid(node, "the time of " + vertex + " is not later than the one before",
                            "order the vertices");
        else
            continue;
        return;
    }
}

/// The trajectory stands directly in the action (1.0), or in a TrajectoryRef, or in a catalogue.
Trajectory parseTrajectoryReference(ElementReader action)
{
    const pugi::xml_node reference = action.node.child("TrajectoryRef");
    ElementReader holder(action.context, reference ? reference : action.node);
    if (const pugi::xml_node catalog = holder.node.child("CatalogReference"))
    {
        CatalogVisit visit({action.context, catalog});
        return visit.entry() ? parseTrajectory({action.context, visit.entry()}) : Trajectory{};
    }
    return parseTrajectory(holder.child("Trajectory"));
}

} // namespace

Trajectory parseTrajectory(ElementReader reader)
{
    reader.allowChildren({"ParameterDeclarations", "Shape"});
    const ParameterScope scope(reader.context, reader.node);
    Trajectory trajectory;
    trajectory.source = reader.context.line(reader.node);
    trajectory.name = reader.name();
    trajectory.closed = reader.flagOr("closed", false);
    trajectory.shape = parseShape(reader.child("Shape"));
    return trajectory;
}

FollowTrajectoryAction parseFollowTrajectory(ElementReader reader)
{
    reader.allowChildren(
        {"Trajectory", "TrajectoryRef", "CatalogReference", "TimeReference", "TrajectoryFollowingMode"});
    FollowTrajectoryAction action;
    action.source = reader.context.line(reader.node);
    action.trajectory = parseTrajectoryReference(reader);
    if (const pugi::xml_node reference = reader.node.child("TimeReference"))
        action.timing = parseTimeReference({reader.context, reference});
    if (const pugi::xml_node mode = reader.node.child("TrajectoryFollowingMode"))
        action.mode = ElementReader(reader.context, mode).choice("followingMode", kFollowingModes);
    action.initialDistanceOffsetM =
        reader.has("initialDistanceOffset") ? reader.notNegative("initialDistanceOffset") : 0.0;
    if (action.timing && !reader.context.isStopped())
        checkTimes(reader.context, reader.node, action.trajectory);
    return action;
}

} // namespace simulation
