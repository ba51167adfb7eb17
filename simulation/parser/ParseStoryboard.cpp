// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/CatalogShelf.h"
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

std::optional<Trigger> parseOptionalTrigger(ElementReader& parent, const char* name)
{
    const pugi::xml_node node = parent.node.child(name);
    if (!node) return std::nullopt;
    Trigger trigger = parseTrigger({parent.context, node});
    // An empty start trigger is in use for one that is not there.
    const bool isStart = std::string_view(name) == "StartTrigger";
    if (isStart && trigger.groups.empty()) return std::nullopt;
    return trigger;
}

Init parseInit(ElementReader reader)
{
    reader.allowChildren({"Actions"});
    ParseContext& context = reader.context;
    ElementReader actions(context, reader.node.child("Actions")); // from 1.1 on it may be missing
    actions.allowChildren({"GlobalAction", "Private"});
    Init init;
    for (pugi::xml_node node : actions.node.children("GlobalAction"))
        init.globals.push_back(parseGlobalAction({context, node}));
    for (pugi::xml_node node : actions.node.children("Private"))
    {
        ElementReader privateReader(context, node);
        privateReader.allowChildren({"PrivateAction"});
        for (const std::string& name : parseEntityRefs(privateReader))
        {
            InitPrivate initial{context.line(node), name, {}};
            for (pugi::xml_node action : node.children("PrivateAction"))
                initial.actions.push_back(parsePrivateAction({context, action}));
            init.privates.push_back(std::move(initial));
        }
    }
    return init;
}

NamedAction parseNamedAction(ElementReader reader)
{
    NamedAction action{reader.context.line(reader.node), reader.name(), PrivateAction{}};
    ElementReader content = reader.onlyChild();
    if (content.is("PrivateAction"))
        action.action = parsePrivateAction(content);
    else if (content.is("GlobalAction"))
        action.action = parseGlobalAction(content);
    else
    {
        if (content.node)
            content.context.foreignChoice(content.node, std::string("the action ") + content.node.name());
        action.action = GlobalAction{Unsupported{action.source, content.node.name()}};
    }
    return action;
}

Event parseEvent(ElementReader reader)
{
    reader.allowChildren({"Action", "StartTrigger"});
    Event event;
    event.source = reader.context.line(reader.node);
    event.name = reader.name();
    event.priority = reader.choiceAssumed("priority", kPriorities);
    event.maximumExecutionCount = reader.count("maximumExecutionCount", 1);
    for (pugi::xml_node node : reader.node.children("Action"))
        event.actions.push_back(parseNamedAction({reader.context, node}));
    if (event.actions.empty())
        reader.context.assumed(reader.node, "an Event has no Action", "it does nothing; add one");
    event.startTrigger = parseOptionalTrigger(reader, "StartTrigger");
    return event;
}

Maneuver parseManeuver(ElementReader reader)
{
    reader.allowChildren({"ParameterDeclarations", "Event"});
    const ParameterScope scope(reader.context, reader.node);
    Maneuver maneuver;
    maneuver.source = reader.context.line(reader.node);
    maneuver.name = reader.name();
    for (pugi::xml_node node : reader.node.children("Event"))
        maneuver.events.push_back(parseEvent({reader.context, node}));
    return maneuver;
}

bool hasPrivateAction(const ManeuverGroup& group)
{
    for (const Maneuver& maneuver : group.maneuvers)
        for (const Event& event : maneuver.events)
            for (const NamedAction& action : event.actions)
                if (std::holds_alternative<PrivateAction>(action.action)) return true;
    return false;
}

ManeuverGroup parseManeuverGroup(ElementReader reader)
{
    reader.allowChildren({"Actors", "CatalogReference", "Maneuver"});
    ParseContext& context = reader.context;
    ManeuverGroup group;
    group.source = context.line(reader.node);
    group.name = reader.name();
    group.maximumExecutionCount = reader.count("maximumExecutionCount", 1);
    ElementReader actors = reader.child("Actors");
    group.selectTriggeringEntities = actors.flagOr("selectTriggeringEntities", false);
    for (pugi::xml_node node : actors.node.children("EntityRef"))
        for (const std::string& name : parseEntityRefs({context, node}))
            group.actors.push_back(name);
    for (pugi::xml_node node : reader.node.children("CatalogReference"))
    {
        CatalogVisit visit({context, node});
        if (visit.entry()) group.maneuvers.push_back(parseManeuver({context, visit.entry()}));
    }
    for (pugi::xml_node node : reader.node.children("Maneuver"))
        group.maneuvers.push_back(parseManeuver({context, node}));
    if (group.actors.empty() && !group.selectTriggeringEntities && hasPrivateAction(group))
        context.unsupported(actors.node, "a private action without actors",
                            "nothing is done; add an EntityRef to Actors");
    return group;
}

Act parseAct(ElementReader reader)
{
    reader.allowChildren({"ManeuverGroup", "StartTrigger", "StopTrigger"});
    Act act;
    act.source = reader.context.line(reader.node);
    act.name = reader.name();
    for (pugi::xml_node node : reader.node.children("ManeuverGroup"))
        act.groups.push_back(parseManeuverGroup({reader.context, node}));
    act.startTrigger = parseOptionalTrigger(reader, "StartTrigger");
    act.stopTrigger = parseOptionalTrigger(reader, "StopTrigger");
    return act;
}

Story parseStory(ElementReader reader)
{
    reader.allowChildren({"ParameterDeclarations", "Act"});
    const ParameterScope scope(reader.context, reader.node);
    Story story;
    story.source = reader.context.line(reader.node);
    story.name = reader.has("name") ? reader.name() : "";
    for (pugi::xml_node node : reader.node.children("Act"))
        story.acts.push_back(parseAct({reader.context, node}));
    return story;
}

} // namespace

Storyboard parseStoryboard(ElementReader reader)
{
    reader.allowChildren({"Init", "Story", "StopTrigger"});
    Storyboard storyboard;
    storyboard.source = reader.context.line(reader.node);
    storyboard.init = parseInit(reader.child("Init"));
    for (pugi::xml_node node : reader.node.children("Story"))
        storyboard.stories.push_back(parseStory({reader.context, node}));
    storyboard.stopTrigger = parseOptionalTrigger(reader, "StopTrigger");
    return storyboard;
}

} // namespace simulation
