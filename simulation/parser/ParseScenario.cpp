// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/ParseScenario.h"

#include <memory>

#include "simulation/parser/CatalogShelf.h"
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

FileHeader parseHeader(ElementReader reader)
{
    reader.allowChildren({"License", "Properties"});
    FileHeader header{reader.count("revMajor", 1), reader.count("revMinor", 0), reader.text("date"),
                      reader.text("author"), reader.text("description")};
    if (header.revMajor != 1)
        reader.context.invalid(reader.node,
                               "OpenSCENARIO XML " + std::to_string(header.revMajor) + " is unknown",
                               "convert the file to 1.0 to 1.3");
    return header;
}

RoadNetwork parseRoadNetwork(ElementReader reader)
{
    reader.allowChildren({"LogicFile", "SceneGraphFile"});
    RoadNetwork network;
    if (const pugi::xml_node node = reader.node.child("LogicFile"))
        network.logicFile = ElementReader(reader.context, node).text("filepath");
    if (const pugi::xml_node node = reader.node.child("SceneGraphFile"))
        network.sceneGraphFile = ElementReader(reader.context, node).text("filepath");
    return network;
}

std::vector<ScenarioObject> parseEntities(ElementReader reader)
{
    reader.allowChildren({"ScenarioObject"});
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
    return objects;
}

Scenario parseRoot(ElementReader reader)
{
    reader.allowChildren(
        {"FileHeader", "ParameterDeclarations", "CatalogLocations", "RoadNetwork", "Entities", "Storyboard"});
    ParseContext& context = reader.context;
    const ParseContext::Scope given(context.options.parameters.begin(), context.options.parameters.end());
    Scenario scenario;
    scenario.header = parseHeader(reader.child("FileHeader"));
    scenario.parameters = context.declareParameters(reader.node, given);
    for (const auto& [name, value] : given)
        if (!context.lookup(name))
            context.invalid(reader.node, "there is no parameter " + name + " to set",
                            "declare it in the scenario");
    if (const pugi::xml_node locations = reader.node.child("CatalogLocations"))
        context.shelf.open(context, locations);
    if (const pugi::xml_node node = reader.node.child("RoadNetwork"))
        scenario.roadNetwork = parseRoadNetwork({context, node});
    scenario.entities = parseEntities(reader.child("Entities"));
    scenario.storyboard = parseStoryboard(reader.child("Storyboard"));
    return scenario;
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
    ParsedScenario parsed;
    parsed.scenario = parseRoot({context, source.root()});
    if (context.isStopped()) return context.problems.front().error;
    parsed.problems = std::move(context.problems);
    return parsed;
}

} // namespace

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
