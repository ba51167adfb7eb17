// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

SignalPhase parsePhase(ElementReader reader, const std::string& controller)
{
    reader.allowChildren({"TrafficSignalState", "TrafficSignalGroupState"});
    SignalPhase phase{reader.text("name"), reader.notNegative("duration"), {}};
    for (pugi::xml_node node : reader.node.children("TrafficSignalState"))
    {
        ElementReader state(reader.context, node);
        phase.states.emplace_back(state.text("trafficSignalId"), state.text("state"));
    }
    if (const pugi::xml_node node = reader.node.child("TrafficSignalGroupState"))
        phase.states.emplace_back(controller, ElementReader(reader.context, node).text("state"));
    return phase;
}

TrafficSignalController parseSignalController(ElementReader reader)
{
    reader.allowChildren({"Phase"});
    TrafficSignalController controller;
    controller.source = reader.context.line(reader.node);
    controller.name = reader.name();
    controller.delayS = reader.has("delay") ? reader.notNegative("delay") : 0.0;
    controller.reference = reader.textOr("reference", "");
    for (pugi::xml_node node : reader.node.children("Phase"))
        controller.phases.push_back(parsePhase({reader.context, node}, controller.name));
    return controller;
}

} // namespace

std::vector<TrafficSignalController> parseTrafficSignals(ElementReader reader)
{
    reader.allowChildren({"TrafficSignalController"});
    std::vector<TrafficSignalController> controllers;
    for (pugi::xml_node node : reader.node.children("TrafficSignalController"))
    {
        controllers.push_back(parseSignalController({reader.context, node}));
        if (!reader.context.signalControllerNames.insert(controllers.back().name).second)
            reader.context.invalid(node,
                                   "the TrafficSignalController " + controllers.back().name + " stands twice",
                                   "rename one");
    }
    for (const TrafficSignalController& controller : controllers)
        if (!controller.reference.empty() &&
            !reader.context.signalControllerNames.contains(controller.reference))
            reader.context.invalid(reader.node,
                                   "the reference " + controller.reference +
                                       " of the TrafficSignalController " + controller.name +
                                       " does not exist",
                                   "name a controller");
    return controllers;
}

std::string parseSignalControllerRef(ElementReader& reader)
{
    std::string name = reader.text("trafficSignalControllerRef");
    if (reader.has("trafficSignalControllerRef") && !reader.context.signalControllerNames.contains(name))
        reader.context.invalid(reader.node, "the TrafficSignalController " + name + " does not exist",
                               "declare it in RoadNetwork/TrafficSignals");
    return name;
}

} // namespace simulation
