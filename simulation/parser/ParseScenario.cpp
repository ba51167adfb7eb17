// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/ParseScenario.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <memory>
#include <utility>

#include "simulation/parser/CatalogShelf.h"
#include "simulation/parser/CoverageWalk.h"
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

RoadNetwork parseRoadNetwork(ElementReader reader)
{
    reader.allowChildren({"LogicFile", "SceneGraphFile", "TrafficSignals"});
    RoadNetwork network;
    if (const pugi::xml_node node = reader.node.child("LogicFile"))
    {
        network.logicFile = ElementReader(reader.context, node).text("filepath");
        network.logicLine = reader.context.line(node);
    }
    reader.context.hasRoads = !network.logicFile.empty();
    if (const pugi::xml_node node = reader.node.child("SceneGraphFile"))
    {
        network.sceneGraphFile = ElementReader(reader.context, node).text("filepath");
        network.sceneLine = reader.context.line(node);
    }
    if (const pugi::xml_node node = reader.node.child("TrafficSignals"))
        network.signalControllers = parseTrafficSignals({reader.context, node});
    return network;
}

std::vector<ScenarioObject> parseEntities(ElementReader reader)
{
    reader.allowChildren({"ScenarioObject", "EntitySelection"});
    std::vector<ScenarioObject> objects;
    for (pugi::xml_node node : reader.node.children("ScenarioObject"))
    {
        for (ScenarioObject& object : parseScenarioObject({reader.context, node}))
        {
            if (!reader.context.entityNames.insert(object.name).second)
                reader.context.invalid(node, "the entity " + object.name + " stands twice", "rename one");
            objects.push_back(std::move(object));
        }
    }
    for (pugi::xml_node node : reader.node.children("EntitySelection"))
    {
        ElementReader selection(reader.context, node);
        const std::string name = selection.has("name") ? selection.name() : selection.text("name");
        if (reader.context.entityNames.contains(name))
            reader.context.invalid(node, "the entity " + name + " stands twice", "rename one");
        reader.context.selections[name] = parseSelection(selection, objects);
    }
    return objects;
}

std::vector<ParameterDeclaration> parseVariables(ElementReader parent)
{
    std::vector<ParameterDeclaration> variables;
    for (pugi::xml_node node : parent.node.child("VariableDeclarations").children("VariableDeclaration"))
    {
        ElementReader reader(parent.context, node);
        variables.push_back({parent.context.line(node), reader.text("name"), reader.text("variableType"),
                             reader.text("value")});
        parent.context.variableNames.insert(variables.back().name);
    }
    return variables;
}

std::vector<MonitorDeclaration> parseMonitors(ElementReader parent)
{
    std::vector<MonitorDeclaration> monitors;
    for (pugi::xml_node node : parent.node.child("MonitorDeclarations").children("MonitorDeclaration"))
    {
        ElementReader reader(parent.context, node);
        monitors.push_back({parent.context.line(node), reader.text("name"), reader.flagOr("value", false)});
        parent.context.monitorNames.insert(monitors.back().name);
    }
    return monitors;
}

Scenario parseRoot(ElementReader reader)
{
    reader.allowChildren({"FileHeader", "ParameterDeclarations", "VariableDeclarations",
                          "MonitorDeclarations", "CatalogLocations", "RoadNetwork", "Entities",
                          "Storyboard"});
    ParseContext& context = reader.context;
    const ParseContext::Scope given(context.options.parameters.begin(), context.options.parameters.end());
    Scenario scenario;
    scenario.header = parseHeader(reader.child("FileHeader"));
    scenario.parameters = context.declareParameters(reader.node, given);
    for (const auto& [name, value] : given)
        if (!context.lookup(name))
            context.invalid(reader.node, "there is no parameter " + name + " to set",
                            "declare it in the scenario");
    scenario.variables = parseVariables(reader);
    scenario.monitors = parseMonitors(reader);
    if (const pugi::xml_node locations = reader.node.child("CatalogLocations"))
        context.shelf.open(context, locations);
    if (const pugi::xml_node node = reader.node.child("RoadNetwork"))
        scenario.roadNetwork = parseRoadNetwork({context, node});
    scenario.entities = parseEntities(reader.child("Entities"));
    scenario.storyboard = parseStoryboard(reader.child("Storyboard"));
    return scenario;
}

/// By file, in the order in which they were found, then by line.
void sortByPlace(std::vector<Problem>& problems)
{
    const auto parts = [](const Problem& problem)
    {
        const std::size_t colon = problem.error.place.rfind(':');
        const bool hasLine = colon != std::string::npos;
        return std::pair(problem.error.place.substr(0, colon),
                         hasLine ? std::atoi(problem.error.place.c_str() + colon + 1) : 0);
    };
    std::map<std::string, std::size_t> files;
    for (const Problem& problem : problems)
        files.emplace(parts(problem).first, files.size());
    std::stable_sort(problems.begin(), problems.end(),
                     [&](const Problem& left, const Problem& right)
                     {
                         const auto a = parts(left), b = parts(right);
                         return std::pair(files[a.first], a.second) < std::pair(files[b.first], b.second);
                     });
}

foundation::Result<ParsedScenario> parseSource(const XmlSource& source, CatalogShelf shelf,
                                               const ParseOptions& options)
{
    const std::string place = source.name() + ":" + std::to_string(source.lineOf(source.root()));
    if (std::string_view(source.root().name()) != "OpenSCENARIO")
        return foundation::Error{place, std::string("the root element is ") + source.root().name(),
                                 "give an OpenSCENARIO file"};
    if (!source.root().child("Storyboard"))
        return foundation::Error{place,
                                 "there is no Storyboard: a catalogue or a distribution, not a scenario",
                                 "give the scenario's file"};
    ParseContext context(options, source, shelf);
    context.tellNote(source);
    ParsedScenario parsed;
    parsed.scenario = parseRoot({context, source.root()});
    reportUnread(context, source.root());
    if (context.isStopped()) return context.problems.front().error;
    parsed.problems = std::move(context.problems);
    parsed.elements = std::move(context.elements);
    sortByPlace(parsed.problems);
    return parsed;
}

} // namespace

FileHeader parseHeader(ElementReader reader)
{
    reader.allowChildren({"License", "Properties"});
    parseProperties(reader);
    FileHeader header{reader.count("revMajor", 1), reader.count("revMinor", 0), reader.textAssumed("date"),
                      reader.textAssumed("author"), reader.textAssumed("description")};
    if (header.revMajor != 1)
        reader.context.invalid(reader.node,
                               "OpenSCENARIO XML " + std::to_string(header.revMajor) + " is unknown",
                               "convert the file to 1.0 to 1.3");
    return header;
}

foundation::Result<ParsedScenario> readScenario(const std::filesystem::path& file,
                                                const ParseOptions& options)
{
    foundation::Result<std::unique_ptr<XmlSource>> source = XmlSource::read(file, options.maximumBytes);
    if (!source) return source.error();
    return parseSource(**source, CatalogShelf(file.parent_path()), options);
}

foundation::Result<ParsedScenario> parseScenario(std::string_view text, const std::string& name,
                                                 const ParseOptions& options)
{
    if (text.size() > options.maximumBytes)
        return foundation::Error{
            name, "larger than the limit of " + std::to_string(options.maximumBytes) + " bytes",
            "split the file"};
    foundation::Result<std::unique_ptr<XmlSource>> source = XmlSource::parse(text, name);
    if (!source) return source.error();
    return parseSource(**source, CatalogShelf(std::nullopt), options);
}

} // namespace simulation
