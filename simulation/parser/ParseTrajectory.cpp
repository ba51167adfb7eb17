// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/CatalogShelf.h"
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

std::optional<Timing> parseTimeReference(ElementReader reader)
{
    if (!reader.hasContent())
    {
        reader.context.assumed(reader.node, "TimeReference is empty",
                               "the speed of the entity moves it; add None");
        return std::nullopt;
    }
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

/// The trajectory stands directly in the action (1.0), or in a TrajectoryRef, or in a catalogue.
Trajectory parseTrajectoryReference(ElementReader action)
{
    const pugi::xml_node reference = action.node.child("TrajectoryRef");
    ElementReader holder(action.context, reference ? reference : action.node);
    if (const pugi::xml_node catalog = holder.node.child("CatalogReference"))
    {
        ElementReader entry(action.context, catalog);
        if (namesTrackFile(entry.textOr("catalogName", "")))
        {
            // A file of recorded tracks in place of a catalogue.
            const Recording recording{entry.text("catalogName"), entry.text("entryName")};
            return {action.context.line(catalog), recording.track.empty() ? recording.file : recording.track,
                    false, Polyline{}, recording};
        }
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
    trajectory.shape = parseTrajectoryShape(reader.child("Shape"));
    return trajectory;
}

TrajectoryPosition parseTrajectoryPosition(ElementReader reader)
{
    reader.allowChildren({"Orientation", "TrajectoryRef"});
    TrajectoryPosition position;
    position.source = reader.context.line(reader.node);
    position.trajectory = std::make_shared<const Trajectory>(parseTrajectoryReference(reader));
    position.sM = reader.notNegative("s");
    position.tM = reader.numberOr("t", 0.0);
    position.orientation = parseOrientationOf(reader);
    return position;
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
    if (action.timing && !action.trajectory.recording && !reader.context.isStopped() &&
        !checkShapeTimes(reader.context, reader.node, action.trajectory.shape))
        action.timing.reset();
    return action;
}

} // namespace simulation
