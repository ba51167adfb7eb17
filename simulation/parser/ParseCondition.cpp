// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

/// Values that are compared as text: ParameterCondition, VariableCondition, UserDefinedValueCondition.
ValueCondition parseValue(ElementReader reader, std::string name)
{
    return {std::move(name), reader.text("value"), reader.choice("rule", kRules)};
}

/// Some programs keep their criteria as conditions on parameters that nobody declares: such a condition is
/// never true.
ConditionContent parseParameterCondition(ElementReader reader)
{
    std::string name = reader.node.attribute("parameterRef").value();
    if (!name.empty() && name.front() == '$') name.erase(0, 1);
    if (!reader.has("parameterRef") || reader.context.lookup(name))
        return parseValue(reader, parseDeclaredName(reader, "parameterRef"));
    reader.has("value");
    reader.has("rule");
    reader.context.unsupported(reader.node,
                               "a condition on the parameter \"" + name + "\", which is not declared,",
                               "it is never true");
    return Unsupported{reader.context.line(reader.node), reader.node.name()};
}

ConditionContent parseContent(ElementReader reader)
{
    ElementReader kind = reader.onlyChild();
    if (kind.is("ByEntityCondition")) return parseEntityCondition(kind);
    if (!kind.is("ByValueCondition")) return unsupportedContent(kind, "condition");
    ElementReader value = kind.onlyChild();
    if (value.is("SimulationTimeCondition"))
        return SimulationTimeCondition{value.bound("value"), value.choice("rule", kRules)};
    if (value.is("StoryboardElementStateCondition"))
        return StoryboardElementStateCondition{value.choice("storyboardElementType", kElementTypes),
                                               value.text("storyboardElementRef"),
                                               value.choice("state", kElementStates)};
    if (value.is("ParameterCondition")) return parseParameterCondition(value);
    if (value.is("VariableCondition")) return parseValue(value, parseDeclaredName(value, "variableRef"));
    if (value.is("UserDefinedValueCondition")) return parseValue(value, value.text("name"));
    if (value.is("TrafficSignalCondition"))
        return TrafficSignalCondition{value.text("name"), value.text("state")};
    if (value.is("TrafficSignalControllerCondition"))
        return TrafficSignalControllerCondition{parseSignalControllerRef(value), value.text("phase")};
    if (value.is("TimeOfDayCondition"))
        return TimeOfDayCondition{parseInstant(value), value.choice("rule", kRules)};
    return unsupportedContent(value, "condition");
}

Condition parseCondition(ElementReader reader)
{
    Condition condition;
    condition.source = reader.context.line(reader.node);
    condition.name = reader.name();
    condition.delayS = reader.has("delay") ? reader.notNegative("delay") : 0.0;
    condition.edge = reader.choiceAssumed("conditionEdge", kConditionEdges);
    condition.content = parseContent(reader);
    return condition;
}

} // namespace

Trigger parseTrigger(ElementReader reader)
{
    reader.allowChildren({"ConditionGroup"});
    Trigger trigger;
    trigger.source = reader.context.line(reader.node);
    for (pugi::xml_node groupNode : reader.node.children("ConditionGroup"))
    {
        ElementReader(reader.context, groupNode).allowChildren({"Condition"});
        ConditionGroup group;
        for (pugi::xml_node node : groupNode.children("Condition"))
            group.conditions.push_back(parseCondition({reader.context, node}));
        if (group.conditions.empty())
            reader.context.unsupported(groupNode, "a ConditionGroup without a Condition",
                                       "it never triggers; add one");
        trigger.groups.push_back(std::move(group));
    }
    return trigger;
}

} // namespace simulation
