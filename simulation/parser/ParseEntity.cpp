// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/CatalogShelf.h"
#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

BoundingBox parseBoundingBox(ElementReader reader)
{
    reader.allowChildren({"Center", "Dimensions"});
    ElementReader centre = reader.child("Center");
    ElementReader dimensions = reader.child("Dimensions");
    return {{centre.number("x"), centre.number("y"), centre.number("z")},
            dimensions.notNegative("length"),
            dimensions.notNegative("width"),
            dimensions.notNegative("height")};
}

Axle parseAxle(ElementReader reader)
{
    return {reader.number("maxSteering"), reader.notNegative("wheelDiameter"),
            reader.notNegative("trackWidth"), reader.number("positionX"), reader.number("positionZ")};
}

Properties parseProperties(ElementReader parent)
{
    Properties properties;
    const pugi::xml_node node = parent.node.child("Properties");
    if (!node) return properties;
    ElementReader(parent.context, node).allowChildren({"Property", "File", "CustomContent"});
    for (pugi::xml_node property : node.children("Property"))
    {
        ElementReader reader(parent.context, property);
        properties.values.emplace_back(reader.text("name"), reader.text("value"));
    }
    for (pugi::xml_node file : node.children("File"))
        properties.files.push_back(ElementReader(parent.context, file).text("filepath"));
    return properties;
}

void parseAxles(ElementReader reader, Vehicle& vehicle)
{
    reader.allowChildren({"FrontAxle", "RearAxle", "AdditionalAxle"});
    if (const pugi::xml_node node = reader.node.child("FrontAxle"))
        vehicle.frontAxle = parseAxle({reader.context, node});
    vehicle.rearAxle = parseAxle(reader.child("RearAxle"));
    for (pugi::xml_node node : reader.node.children("AdditionalAxle"))
        vehicle.additionalAxles.push_back(parseAxle({reader.context, node}));
}

/// A hitch and a coupler are noted; a trailer itself comes with a later version, unless its reference is
/// empty.
void parseTrailer(ElementReader reader, Vehicle& vehicle)
{
    if (const pugi::xml_node node = reader.node.child("TrailerHitch"))
        vehicle.trailerHitchDxM = ElementReader(reader.context, node).number("dx");
    if (const pugi::xml_node node = reader.node.child("TrailerCoupler"))
        vehicle.trailerCouplerDxM = ElementReader(reader.context, node).number("dx");
    const pugi::xml_node trailer = reader.node.child("Trailer");
    if (!trailer) return;
    const pugi::xml_node reference = trailer.child("TrailerRef");
    const bool isEmpty =
        reference && ElementReader(reader.context, reference).textOr("entityRef", "").empty();
    if (!isEmpty) reader.context.unsupported(trailer, "a Trailer");
}

Vehicle parseVehicle(ElementReader reader)
{
    reader.allowChildren({"ParameterDeclarations", "BoundingBox", "Performance", "Axles", "Properties",
                          "TrailerHitch", "TrailerCoupler", "Trailer"});
    ParseContext& context = reader.context;
    Vehicle vehicle;
    vehicle.source = context.line(reader.node);
    vehicle.name = reader.name();
    vehicle.category = reader.text("vehicleCategory");
    vehicle.model3d = reader.textOr("model3d", "");
    vehicle.massKg = reader.optionalNumber("mass");
    vehicle.box = parseBoundingBox(reader.child("BoundingBox"));
    ElementReader performance = reader.child("Performance");
    vehicle.performance = {performance.notNegative("maxSpeed"), performance.notNegative("maxAcceleration"),
                           performance.notNegative("maxDeceleration")};
    parseAxles(reader.child("Axles"), vehicle);
    parseTrailer(reader, vehicle);
    vehicle.properties = parseProperties(reader);
    return vehicle;
}

template<class Object>
Object parseSimpleObject(ElementReader reader, const char* categoryAttribute)
{
    reader.allowChildren({"ParameterDeclarations", "BoundingBox", "Properties"});
    Object object;
    object.source = reader.context.line(reader.node);
    object.name = reader.name();
    object.category = reader.text(categoryAttribute);
    object.model3d = reader.textOr("model3d", reader.textOr("model", ""));
    object.massKg = reader.numberOr("mass", 0.0);
    object.box = parseBoundingBox(reader.child("BoundingBox"));
    object.properties = parseProperties(reader);
    return object;
}

decltype(ScenarioObject::object) parseObject(ElementReader reader)
{
    if (reader.is("CatalogReference"))
    {
        CatalogVisit visit(reader);
        if (visit.entry()) return parseObject({reader.context, visit.entry()});
        return Unsupported{reader.context.line(reader.node), "CatalogReference"};
    }
    const ParameterScope scope(reader.context, reader.node);
    if (reader.is("Vehicle")) return parseVehicle(reader);
    if (reader.is("Pedestrian")) return parseSimpleObject<Pedestrian>(reader, "pedestrianCategory");
    if (reader.is("MiscObject")) return parseSimpleObject<MiscObject>(reader, "miscObjectCategory");
    reader.context.unsupported(reader.node, std::string("the object ") + reader.node.name());
    return Unsupported{reader.context.line(reader.node), reader.node.name()};
}

} // namespace

ScenarioObject parseScenarioObject(ElementReader reader)
{
    ScenarioObject object;
    object.source = reader.context.line(reader.node);
    object.name = reader.name();
    bool hasObject = false;
    for (pugi::xml_node node : reader.node.children())
    {
        if (node.type() != pugi::node_element) continue;
        if (hasObject)
            reader.context.unsupported(node,
                                       std::string("the element ") + node.name() + " in ScenarioObject");
        else
            object.object = parseObject({reader.context, node});
        hasObject = true;
    }
    if (!hasObject) reader.context.invalid(reader.node, "the ScenarioObject is empty", "add a Vehicle");
    return object;
}

} // namespace simulation
