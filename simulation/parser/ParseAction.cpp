// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

/// Nothing here looks with sensors.
PrivateAction parseVisibility(ElementReader reader)
{
    return VisibilityAction{reader.context.line(reader.node), reader.flagOr("graphics", true),
                            reader.flagOr("traffic", true), reader.flagOr("sensors", true)};
}

PrivateAction parseActivateController(ElementReader reader)
{
    ActivateControllerAction action;
    action.source = reader.context.line(reader.node);
    action.controller = reader.textOr("objectControllerRef", reader.textOr("controllerRef", ""));
    if (reader.has("longitudinal")) action.longitudinal = reader.flagOr("longitudinal", false);
    if (reader.has("lateral")) action.lateral = reader.flagOr("lateral", false);
    return action;
}

AssignControllerAction parseAssignController(ElementReader reader)
{
    AssignControllerAction action;
    action.source = reader.context.line(reader.node);
    if (reader.has("activateLongitudinal"))
        action.longitudinal = reader.flagOr("activateLongitudinal", false);
    if (reader.has("activateLateral")) action.lateral = reader.flagOr("activateLateral", false);
    ElementReader content = reader.onlyChild();
    action.controller =
        content.is("ObjectController") ? parseObjectController(content) : parseController(content);
    return action;
}

LightStateAction parseLightState(ElementReader reader)
{
    LightStateAction action;
    action.source = reader.context.line(reader.node);
    ElementReader type = reader.child("LightType").onlyChild();
    if (type.is("VehicleLight"))
        action.light = type.text("vehicleLightType");
    else if (type.is("UserDefinedLight"))
        action.light = type.text("userDefinedLightType");
    else
        unsupportedContent(type, "light");
    ElementReader state = reader.child("LightState");
    action.mode = state.choice("mode", kLightModes);
    action.onS = state.numberOr("flashingOnDuration", action.onS);
    action.offS = state.numberOr("flashingOffDuration", action.offS);
    return action;
}

/// A person's gestures stand for its motion where there is none.
std::string partOfPerson(ElementReader reader)
{
    reader.allowChildren({"PedestrianGesture"});
    std::string part = reader.textOr("motion", reader.textOr("userDefinedPedestrianAnimation", ""));
    for (pugi::xml_node node : reader.node.children("PedestrianGesture"))
    {
        const std::string gesture = ElementReader(reader.context, node).text("gesture");
        part += (part.empty() ? "" : "+") + gesture;
    }
    return part;
}

std::string animatedPart(ElementReader type)
{
    ElementReader content = type.onlyChild();
    if (content.is("PedestrianAnimation")) return partOfPerson(content);
    if (content.is("AnimationFile")) return content.child("File").text("filepath");
    if (content.is("UserDefinedAnimation")) return content.text("userDefinedAnimationType");
    if (content.is("ComponentAnimation"))
    {
        ElementReader component = content.onlyChild();
        if (component.is("VehicleComponent")) return component.text("vehicleComponentType");
        if (component.is("UserDefinedComponent")) return component.text("userDefinedComponentType");
        unsupportedContent(component, "component");
        return {};
    }
    unsupportedContent(content, "animation");
    return {};
}

AnimationAction parseAnimation(ElementReader reader)
{
    AnimationAction action;
    action.source = reader.context.line(reader.node);
    action.part = animatedPart(reader.child("AnimationType"));
    if (const pugi::xml_node node = reader.node.child("AnimationState"))
        action.state = ElementReader(reader.context, node).number("state");
    if (reader.has("animationDuration")) action.durationS = reader.notNegative("animationDuration");
    action.isLoop = reader.flagOr("loop", false);
    return action;
}

PrivateAction parseAppearance(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("LightStateAction")) return parseLightState(content);
    if (content.is("AnimationAction")) return parseAnimation(content);
    return unsupportedContent(content, "action");
}

PrivateAction parseTrailerAction(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    TrailerAction action;
    action.source = reader.context.line(reader.node);
    if (content.is("ConnectTrailerAction"))
        action.trailer = parseEntityRef(content, "trailerRef");
    else if (!content.is("DisconnectTrailerAction"))
        return unsupportedContent(content, "action");
    return action;
}

/// From 1.1 on a ControllerAction has one of the actions on controllers; in 1.0 two of them stand in it
/// together.
PrivateAction parseControllerAction(ElementReader reader)
{
    reader.allowChildren(
        {"AssignControllerAction", "ActivateControllerAction", "OverrideControllerValueAction"});
    const pugi::xml_node assigned = reader.node.child("AssignControllerAction");
    const pugi::xml_node overridden = reader.node.child("OverrideControllerValueAction");
    if (assigned)
    {
        AssignControllerAction action = parseAssignController({reader.context, assigned});
        if (overridden) action.overrides = parseOverride({reader.context, overridden});
        return action;
    }
    if (!reader.hasContent())
    {
        reader.context.assumed(reader.node, "ControllerAction is empty", "nothing is done; add its content");
        return Unsupported{reader.context.line(reader.node), reader.node.name()};
    }
    ElementReader content = reader.onlyChild();
    if (content.is("ActivateControllerAction")) return parseActivateController(content);
    if (content.is("OverrideControllerValueAction")) return parseOverride(content);
    return unsupportedContent(content, "action");
}

} // namespace

Unsupported unsupportedContent(ElementReader& reader, const char* kind)
{
    if (reader.node)
        reader.context.foreignChoice(reader.node, std::string("the ") + kind + " " + reader.node.name());
    return {reader.context.line(reader.node), reader.node.name()};
}

PrivateAction parsePrivateAction(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("TeleportAction"))
        return TeleportAction{content.context.line(content.node), parsePosition(content.child("Position"))};
    if (content.is("LongitudinalAction")) return parseLongitudinalAction(content);
    if (content.is("LateralAction")) return parseLateralAction(content);
    if (content.is("RoutingAction")) return parseRoutingAction(content);
    if (content.is("SynchronizeAction")) return parseSynchronizeAction(content);
    if (content.is("ActivateControllerAction")) return parseActivateController(content);
    if (content.is("ControllerAction")) return parseControllerAction(content);
    if (content.is("VisibilityAction")) return parseVisibility(content);
    if (content.is("AppearanceAction")) return parseAppearance(content);
    if (content.is("TrailerAction")) return parseTrailerAction(content);
    return unsupportedContent(content, "action");
}

} // namespace simulation
