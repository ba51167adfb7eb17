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
        CatalogVisit visit({reader.context, reference}, "the environment stays as it is");
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
    action.name = parseDeclaredName(reader, attribute);
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
    if (content.is("TrafficSignalControllerAction"))
        return TrafficSignalControllerAction{content.context.line(content.node),
                                             parseSignalControllerRef(content), content.text("phase")};
    if (content.is("TrafficSignalStateAction"))
        return TrafficSignalStateAction{reader.context.line(content.node), content.text("name"),
                                        content.text("state")};
    return unsupportedContent(content, "action");
}

GlobalAction parseEntityAction(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    EntityAction action{reader.context.line(reader.node), parseEntityRef(reader, "entityRef"), true, {}};
    if (content.is("DeleteEntityAction")) return action;
    if (content.is("AddEntityAction"))
    {
        action.isDeleted = false;
        action.position = parsePosition(content.child("Position"));
        return action;
    }
    return unsupportedContent(content, "action");
}

} // namespace

std::string parseDeclaredName(ElementReader& reader, const char* attribute)
{
    ParseContext& context = reader.context;
    if (!reader.has(attribute)) return reader.text(attribute);
    std::string name = reader.node.attribute(attribute).value(); // a name, with or without $: not a value
    if (!name.empty() && name.front() == '$') name.erase(0, 1);
    const std::string_view kind =
        std::string_view(attribute).substr(0, std::string_view(attribute).size() - 3);
    const bool isDeclared = kind == "parameter"  ? context.lookup(name).has_value()
                            : kind == "variable" ? context.variableNames.contains(name)
                                                 : context.monitorNames.contains(name);
    if (!isDeclared)
        context.invalid(reader.node, "the " + std::string(kind) + " " + name + " is not declared",
                        "declare it at the root");
    return name;
}

GlobalAction parseGlobalAction(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    if (content.is("EnvironmentAction")) return parseEnvironmentAction(content);
    if (content.is("ParameterAction")) return parseSetValue(content, "parameterRef");
    if (content.is("VariableAction")) return parseSetValue(content, "variableRef");
    if (content.is("SetMonitorAction"))
        return SetMonitorAction{content.context.line(content.node), parseDeclaredName(content, "monitorRef"),
                                content.flagOr("value", false)};
    if (content.is("InfrastructureAction")) return parseInfrastructure(content);
    if (content.is("EntityAction")) return parseEntityAction(content);
    if (content.is("TrafficAction")) return parseTrafficAction(content);
    return unsupportedContent(content, "action");
}

} // namespace simulation
