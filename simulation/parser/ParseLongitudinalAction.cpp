// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

RelativeTargetSpeed parseRelativeSpeed(ElementReader reader)
{
    return {parseEntityRef(reader, "entityRef"), reader.number("value"),
            reader.choice("speedTargetValueType", kSpeedValueTypes), reader.flagOr("continuous", false)};
}

SpeedTarget parseSpeedTarget(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("AbsoluteTargetSpeed")) return AbsoluteTargetSpeed{content.number("value")};
    if (content.is("RelativeTargetSpeed")) return parseRelativeSpeed(content);
    return unsupportedContent(content, "speed target");
}

SpeedAction parseSpeedAction(ElementReader reader)
{
    reader.allowChildren({"SpeedActionDynamics", "SpeedActionTarget"});
    return {reader.context.line(reader.node), parseDynamics(reader.child("SpeedActionDynamics")),
            parseSpeedTarget(reader.child("SpeedActionTarget"))};
}

DynamicConstraints parseConstraints(ElementReader reader)
{
    return {reader.optionalBound("maxSpeed"), reader.optionalBound("maxAcceleration"),
            reader.optionalBound("maxDeceleration"), reader.optionalBound("maxAccelerationRate"),
            reader.optionalBound("maxDecelerationRate")};
}

SpeedProfileAction parseSpeedProfile(ElementReader reader)
{
    reader.allowChildren({"DynamicConstraints", "SpeedProfileEntry"});
    SpeedProfileAction action;
    action.source = reader.context.line(reader.node);
    action.isSmooth = reader.choice("followingMode", kFollowingModes) == FollowingMode::follow;
    if (const pugi::xml_node node = reader.node.child("DynamicConstraints"))
        action.constraints = parseConstraints({reader.context, node});
    for (pugi::xml_node node : reader.node.children("SpeedProfileEntry"))
    {
        ElementReader entry(reader.context, node);
        action.entries.push_back({entry.optionalNumber("time"), entry.number("speed")});
    }
    if (action.entries.empty())
        reader.context.invalid(reader.node, "a SpeedProfileAction has no SpeedProfileEntry", "add one");
    return action;
}

LongitudinalDistanceAction parseLongitudinalDistance(ElementReader reader)
{
    reader.allowChildren({"DynamicConstraints"});
    LongitudinalDistanceAction action;
    action.source = reader.context.line(reader.node);
    action.entity = parseEntityRef(reader, "entityRef");
    action.distanceM = reader.optionalNumber("distance");
    action.timeGapS = reader.optionalNumber("timeGap");
    if (!action.distanceM && !action.timeGapS)
        reader.context.invalid(reader.node, "neither distance nor timeGap is given", "add one of them");
    action.isContinuous = reader.flagOr("continuous", false);
    action.measure = parseDistanceMeasure(reader);
    action.measure.kind = DistanceKind::longitudinal;
    action.side = reader.choiceOr("displacement", kDisplacements, 1);
    if (const pugi::xml_node node = reader.node.child("DynamicConstraints"))
    {
        action.isLimited = true;
        action.constraints = parseConstraints({reader.context, node});
    }
    return action;
}

} // namespace

TransitionDynamics parseDynamics(ElementReader reader)
{
    TransitionDynamics dynamics;
    dynamics.shape = reader.choice("dynamicsShape", kDynamicsShapes);
    const bool isStep = dynamics.shape == DynamicsShape::step; // what else there is changes nothing
    dynamics.dimension = isStep ? reader.choiceAssumed("dynamicsDimension", kDynamicsDimensions)
                                : reader.choice("dynamicsDimension", kDynamicsDimensions);
    dynamics.value = isStep ? reader.numberAssumed("value", 0.0) : reader.number("value");
    return dynamics;
}

PrivateAction parseLongitudinalAction(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("SpeedAction")) return parseSpeedAction(content);
    if (content.is("SpeedProfileAction")) return parseSpeedProfile(content);
    if (content.is("LongitudinalDistanceAction")) return parseLongitudinalDistance(content);
    return unsupportedContent(content, "action");
}

} // namespace simulation
