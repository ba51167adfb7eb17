// SPDX-License-Identifier: Apache-2.0
#include "simulation/writer/WriteScenario.h"

#include <sstream>

#include "simulation/writer/ElementWriter.h"

namespace simulation
{

foundation::Result<std::string> scenarioText(const Scenario& scenario)
{
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version").set_value("1.0");
    declaration.append_attribute("encoding").set_value("UTF-8");
    std::string unwritable;
    ElementWriter root(document.append_child("OpenSCENARIO"), unwritable);
    root.child("FileHeader")
        .set("revMajor", 1)
        .set("revMinor", 3)
        .set("date", scenario.header.date)
        .set("description", scenario.header.description)
        .set("author", scenario.header.author);
    ElementWriter parameters = root.child("ParameterDeclarations");
    for (const ParameterDeclaration& parameter : scenario.parameters)
        parameters.child("ParameterDeclaration")
            .set("name", parameter.name)
            .set("parameterType", parameter.type)
            .set("value", parameter.value);
    root.child("CatalogLocations");
    ElementWriter network = root.child("RoadNetwork");
    if (!scenario.roadNetwork.logicFile.empty())
        network.child("LogicFile").set("filepath", scenario.roadNetwork.logicFile);
    if (!scenario.roadNetwork.sceneGraphFile.empty())
        network.child("SceneGraphFile").set("filepath", scenario.roadNetwork.sceneGraphFile);
    ElementWriter entities = root.child("Entities");
    for (const ScenarioObject& object : scenario.entities)
        writeScenarioObject(entities, object);
    writeStoryboard(root, scenario.storyboard);
    if (!scenario.variables.empty()) root.refuse({{}, "VariableDeclarations"});
    if (!scenario.monitors.empty()) root.refuse({{}, "MonitorDeclarations"});
    if (!scenario.roadNetwork.signalControllers.empty()) root.refuse({{}, "TrafficSignals"});
    if (!unwritable.empty())
        return foundation::Error{"scenario", unwritable + " is not supported and cannot be written",
                                 "remove it"};
    std::ostringstream text;
    document.save(text, "    ");
    return text.str();
}

} // namespace simulation
