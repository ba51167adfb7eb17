// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/CatalogShelf.h"
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

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

/// ParameterAction (1.0, 1.1) and VariableAction (from 1.2 on).
GlobalAction parseSetValue(ElementReader reader, const char* attribute)
{
    SetValueAction action;
    action.source = reader.context.line(reader.node);
    action.name = reader.text(attribute);
    ElementReader content = reader.onlyChild();
    if (content.is("SetAction"))
        action.value = content.text("value");
    else if (content.is("ModifyAction"))
    {
        ElementReader rule = content.child("Rule").onlyChild();
        const bool isSum = rule.is("AddValue");
        if (!isSum && !rule.is("MultiplyByValue")) return unsupportedContent(rule, "rule");
        action.change = isSum ? SetValueAction::Change::add : SetValueAction::Change::multiply;
        action.value = rule.text("value");
    }
    else
        return unsupportedContent(content, "action");
    return action;
}

GlobalAction parseInfrastructure(ElementReader reader)
{
    ElementReader content = reader.child("TrafficSignalAction").onlyChild();
    if (content.is("TrafficSignalStateAction"))
        return TrafficSignalStateAction{reader.context.line(content.node), content.text("name"),
                                        content.text("state")};
    return unsupportedContent(content, "action");
}

GlobalAction parseEntityAction(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("DeleteEntityAction"))
        return EntityAction{reader.context.line(reader.node), parseEntityRef(reader, "entityRef"), true};
    return unsupportedContent(content, "action");
}

} // namespace

GlobalAction parseGlobalAction(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("EnvironmentAction")) return parseEnvironmentAction(content);
    if (content.is("ParameterAction")) return parseSetValue(content, "parameterRef");
    if (content.is("VariableAction")) return parseSetValue(content, "variableRef");
    if (content.is("InfrastructureAction")) return parseInfrastructure(content);
    if (content.is("EntityAction")) return parseEntityAction(content);
    return unsupportedContent(content, "action");
}

} // namespace simulation
