// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

/// AbsoluteSpeed or RelativeSpeedToMaster.
void parseFinalSpeed(ElementReader reader, SynchronizeAction& action)
{
    ElementReader content = reader.onlyChild();
    if (content.is("AbsoluteSpeed"))
        action.finalSpeed = AbsoluteTargetSpeed{content.number("value")};
    else if (content.is("RelativeSpeedToMaster"))
        action.finalSpeed =
            RelativeTargetSpeed{action.master, content.number("value"),
                                content.choice("speedTargetValueType", kSpeedValueTypes), false};
    else
        unsupportedContent(content, "final speed");
    content.allowChildren({"TargetDistanceSteadyState", "TargetTimeSteadyState"});
    if (const pugi::xml_node node = content.node.child("TargetDistanceSteadyState"))
        action.steadyDistanceM = ElementReader(reader.context, node).notNegative("distance");
    else if (const pugi::xml_node time = content.node.child("TargetTimeSteadyState"))
        action.steadyTimeS = ElementReader(reader.context, time).notNegative("time");
}

} // namespace

PrivateAction parseRoutingAction(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    const SourceLine source = content.context.line(content.node);
    if (content.is("FollowTrajectoryAction")) return parseFollowTrajectory(content);
    if (content.is("AssignRouteAction")) return AssignRouteAction{source, parseRouteIn(content)};
    if (content.is("AcquirePositionAction"))
        return AcquirePositionAction{source, parsePosition(content.child("Position"))};
    if (content.is("RandomRouteAction")) return RandomRouteAction{source};
    return unsupportedContent(content, "action");
}

PrivateAction parseSynchronizeAction(ElementReader reader)
{
    reader.allowChildren({"TargetPositionMaster", "TargetPosition", "FinalSpeed"});
    SynchronizeAction action;
    action.source = reader.context.line(reader.node);
    action.master = parseEntityRef(reader, "masterEntityRef");
    action.masterPosition = parsePosition(reader.child("TargetPositionMaster"));
    action.position = parsePosition(reader.child("TargetPosition"));
    action.masterToleranceM = reader.numberOr("targetToleranceMaster", 1.0);
    action.toleranceM = reader.numberOr("targetTolerance", 1.0);
    if (const pugi::xml_node node = reader.node.child("FinalSpeed"))
        parseFinalSpeed({reader.context, node}, action);
    return action;
}

} // namespace simulation
