// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

LaneChangeAction parseLaneChange(ElementReader reader)
{
    reader.allowChildren({"LaneChangeActionDynamics", "LaneChangeTarget"});
    LaneChangeAction action;
    action.source = reader.context.line(reader.node);
    action.dynamics = parseDynamics(reader.child("LaneChangeActionDynamics"));
    action.targetOffsetM = reader.numberOr("targetLaneOffset", 0.0);
    ElementReader target = reader.child("LaneChangeTarget").onlyChild();
    if (target.is("RelativeTargetLane"))
        action.entity = parseEntityRef(target, "entityRef");
    else if (!target.is("AbsoluteTargetLane"))
        unsupportedContent(target, "lane change target");
    action.lane = static_cast<int>(target.number("value"));
    if (target.is("AbsoluteTargetLane") && target.has("value") && action.lane == 0)
        target.context.invalid(target.node,
                               "AbsoluteTargetLane/value is 0, the reference line, where nobody drives",
                               "write the id of a lane");
    return action;
}

LaneOffsetAction parseLaneOffset(ElementReader reader)
{
    reader.allowChildren({"LaneOffsetActionDynamics", "LaneOffsetTarget"});
    LaneOffsetAction action;
    action.source = reader.context.line(reader.node);
    action.isContinuous = reader.flagOr("continuous", false);
    if (const pugi::xml_node node = reader.node.child("LaneOffsetActionDynamics"))
    {
        ElementReader dynamics(reader.context, node);
        action.shape = dynamics.choice("dynamicsShape", kDynamicsShapes);
        action.maxLateralAccelerationMps2 = dynamics.optionalBound("maxLateralAcc");
        if (action.maxLateralAccelerationMps2 == 0.0)
            reader.context.assumed(node, "maxLateralAcc is 0, with which nothing moves sideways",
                                   "the entity keeps its offset; write a number above 0");
    }
    else
        reader.context.assumed(reader.node, "LaneOffsetAction has no element LaneOffsetActionDynamics",
                               "the offset is there at once; add it");
    ElementReader target = reader.child("LaneOffsetTarget").onlyChild();
    if (target.is("RelativeTargetLaneOffset"))
        action.entity = parseEntityRef(target, "entityRef");
    else if (!target.is("AbsoluteTargetLaneOffset"))
        unsupportedContent(target, "lane offset target");
    action.offsetM = target.number("value");
    return action;
}

LateralDistanceAction parseLateralDistance(ElementReader reader)
{
    reader.allowChildren({"DynamicConstraints"});
    LateralDistanceAction action;
    action.source = reader.context.line(reader.node);
    action.entity = parseEntityRef(reader, "entityRef");
    action.distanceM = reader.numberOr("distance", 0.0);
    action.isContinuous = reader.flagOr("continuous", false);
    action.measure = parseDistanceMeasure(reader);
    action.measure.kind = DistanceKind::lateral;
    action.side = reader.choiceOr("displacement", kLateralDisplacements, 0);
    if (const pugi::xml_node node = reader.node.child("DynamicConstraints"))
        action.maxSpeedMps = ElementReader(reader.context, node).optionalBound("maxSpeed");
    return action;
}

} // namespace

PrivateAction parseLateralAction(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("LaneChangeAction")) return parseLaneChange(content);
    if (content.is("LaneOffsetAction")) return parseLaneOffset(content);
    if (content.is("LateralDistanceAction")) return parseLateralDistance(content);
    return unsupportedContent(content, "action");
}

} // namespace simulation
