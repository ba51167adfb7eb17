// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/CatalogShelf.h"
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

Unsupported unsupported(ElementReader& reader, const char* kind)
{
    if (reader.node)
        reader.context.unsupported(reader.node, std::string("the ") + kind + " " + reader.node.name());
    return {reader.context.line(reader.node), reader.node.name()};
}

SpeedTarget parseSpeedTarget(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("AbsoluteTargetSpeed")) return AbsoluteTargetSpeed{content.number("value")};
    return unsupported(content, "speed target");
}

SpeedAction parseSpeedAction(ElementReader reader)
{
    reader.allowChildren({"SpeedActionDynamics", "SpeedActionTarget"});
    ElementReader dynamics = reader.child("SpeedActionDynamics");
    SpeedAction action;
    action.source = reader.context.line(reader.node);
    action.dynamics.shape = dynamics.choice("dynamicsShape", kDynamicsShapes);
    action.dynamics.dimension = dynamics.choice("dynamicsDimension", kDynamicsDimensions);
    action.dynamics.value = dynamics.number("value");
    action.target = parseSpeedTarget(reader.child("SpeedActionTarget"));
    return action;
}

PrivateAction parseLongitudinalAction(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("SpeedAction")) return parseSpeedAction(content);
    return unsupported(content, "action");
}

PrivateAction parseRoutingAction(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("FollowTrajectoryAction")) return parseFollowTrajectory(content);
    return unsupported(content, "action");
}

EnvironmentAction parseEnvironmentAction(ElementReader reader)
{
    EnvironmentAction action;
    action.source = reader.context.line(reader.node);
    if (const pugi::xml_node reference = reader.node.child("CatalogReference"))
    {
        CatalogVisit visit({reader.context, reference});
        if (visit.entry()) action.environment = parseEnvironment({reader.context, visit.entry()});
        return action;
    }
    action.environment = parseEnvironment(reader.child("Environment"));
    return action;
}

} // namespace

PrivateAction parsePrivateAction(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("TeleportAction"))
        return TeleportAction{content.context.line(content.node), parsePosition(content.child("Position"))};
    if (content.is("LongitudinalAction")) return parseLongitudinalAction(content);
    if (content.is("RoutingAction")) return parseRoutingAction(content);
    return unsupported(content, "action");
}

GlobalAction parseGlobalAction(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("EnvironmentAction")) return parseEnvironmentAction(content);
    return unsupported(content, "action");
}

} // namespace simulation
