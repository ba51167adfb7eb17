// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/Keywords.h"
#include "simulation/writer/ElementWriter.h"

namespace simulation
{
namespace
{

void writeContent(ElementWriter parent, const SimulationTimeCondition& condition)
{
    parent.child("ByValueCondition")
        .child("SimulationTimeCondition")
        .set("value", condition.seconds)
        .set("rule", wordFor(kRules, condition.rule));
}

void writeContent(ElementWriter parent, const StoryboardElementStateCondition& condition)
{
    parent.child("ByValueCondition")
        .child("StoryboardElementStateCondition")
        .set("storyboardElementType", wordFor(kElementTypes, condition.type))
        .set("storyboardElementRef", condition.element)
        .set("state", wordFor(kElementStates, condition.state));
}

void writeTrigger(ElementWriter parent, const char* name, const std::optional<Trigger>& trigger)
{
    if (!trigger) return;
    ElementWriter element = parent.child(name);
    for (const ConditionGroup& group : trigger->groups)
    {
        ElementWriter groupElement = element.child("ConditionGroup");
        for (const Condition& condition : group.conditions)
        {
            ElementWriter conditionElement = groupElement.child("Condition");
            conditionElement.set("name", condition.name)
                .set("delay", condition.delayS)
                .set("conditionEdge", wordFor(kConditionEdges, condition.edge));
            std::visit([&](const auto& content) { writeContent(conditionElement, content); },
                       condition.content);
        }
    }
}

void writeInit(ElementWriter parent, const Init& init)
{
    ElementWriter actions = parent.child("Init").child("Actions");
    for (const GlobalAction& action : init.globals)
        writeGlobalAction(actions, action);
    for (const InitPrivate& initial : init.privates)
    {
        ElementWriter element = actions.child("Private");
        element.set("entityRef", initial.entity);
        for (const PrivateAction& action : initial.actions)
            writePrivateAction(element, action);
    }
}

void writeEvent(ElementWriter parent, const Event& event)
{
    ElementWriter element = parent.child("Event");
    const std::string_view priority =
        event.priority == Priority::overwrite ? "override" : wordFor(kPriorities, event.priority);
    element.set("name", event.name)
        .set("priority", priority)
        .set("maximumExecutionCount", event.maximumExecutionCount);
    for (const NamedAction& named : event.actions)
    {
        ElementWriter action = element.child("Action");
        action.set("name", named.name);
        if (const auto* content = std::get_if<PrivateAction>(&named.action))
            writePrivateAction(action, *content);
        else
            writeGlobalAction(action, std::get<GlobalAction>(named.action));
    }
    writeTrigger(element, "StartTrigger", event.startTrigger);
}

void writeGroup(ElementWriter parent, const ManeuverGroup& group)
{
    ElementWriter element = parent.child("ManeuverGroup");
    element.set("name", group.name).set("maximumExecutionCount", group.maximumExecutionCount);
    ElementWriter actors = element.child("Actors");
    actors.set("selectTriggeringEntities", group.selectTriggeringEntities);
    for (const std::string& actor : group.actors)
        actors.child("EntityRef").set("entityRef", actor);
    for (const Maneuver& maneuver : group.maneuvers)
    {
        ElementWriter maneuverElement = element.child("Maneuver");
        maneuverElement.set("name", maneuver.name);
        for (const Event& event : maneuver.events)
            writeEvent(maneuverElement, event);
    }
}

} // namespace

void writeStoryboard(ElementWriter parent, const Storyboard& storyboard)
{
    ElementWriter element = parent.child("Storyboard");
    writeInit(element, storyboard.init);
    for (const Story& story : storyboard.stories)
    {
        ElementWriter storyElement = element.child("Story");
        storyElement.set("name", story.name);
        for (const Act& act : story.acts)
        {
            ElementWriter actElement = storyElement.child("Act");
            actElement.set("name", act.name);
            for (const ManeuverGroup& group : act.groups)
                writeGroup(actElement, group);
            writeTrigger(actElement, "StartTrigger", act.startTrigger);
            writeTrigger(actElement, "StopTrigger", act.stopTrigger);
        }
    }
    writeTrigger(element, "StopTrigger", storyboard.stopTrigger);
}

} // namespace simulation
