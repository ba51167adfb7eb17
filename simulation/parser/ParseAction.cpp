// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

/// An action that is seen and moves nothing: its content is not read.
NotedAction noted(ElementReader& reader)
{
    return {reader.context.line(reader.node), reader.node.name()};
}

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
    if (reader.has("longitudinal")) action.longitudinal = reader.flagOr("longitudinal", false);
    if (reader.has("lateral")) action.lateral = reader.flagOr("lateral", false);
    return action;
}

/// From 1.1 on the actions on controllers stand in a ControllerAction.
PrivateAction parseControllerAction(ElementReader reader)
{
    const pugi::xml_node activate = reader.node.child("ActivateControllerAction");
    if (activate) return parseActivateController({reader.context, activate});
    ElementReader content = reader.onlyChild();
    return unsupportedContent(content, "action");
}

} // namespace

Unsupported unsupportedContent(ElementReader& reader, const char* kind)
{
    if (reader.node)
        reader.context.foreign(reader.node, std::string("the ") + kind + " " + reader.node.name());
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
    if (content.is("AppearanceAction")) return noted(content);
    return unsupportedContent(content, "action");
}

} // namespace simulation
