// SPDX-License-Identifier: Apache-2.0
#include <string_view>

#include <foundation/NearestWord.h>

#include "simulation/parser/CatalogShelf.h"
#include "simulation/parser/ElementParsers.h"
#include "simulation/parser/Expression.h"
#include "simulation/scenario/DefaultVehicle.h"

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

void parseAxles(ElementReader reader, Vehicle& vehicle)
{
    reader.allowChildren({"FrontAxle", "RearAxle", "AdditionalAxle"});
    if (const pugi::xml_node node = reader.node.child("FrontAxle"))
        vehicle.frontAxle = parseAxle({reader.context, node});
    vehicle.rearAxle = parseAxle(reader.child("RearAxle"));
    for (pugi::xml_node node : reader.node.children("AdditionalAxle"))
        vehicle.additionalAxles.push_back(parseAxle({reader.context, node}));
}

/// Hitch, coupler and the reference to a trailer. One that is defined in place is read by parseTrailers().
void parseHitch(ElementReader reader, Vehicle& vehicle)
{
    if (const pugi::xml_node node = reader.node.child("TrailerHitch"))
        vehicle.trailerHitchDxM = ElementReader(reader.context, node).number("dx");
    if (const pugi::xml_node node = reader.node.child("TrailerCoupler"))
        vehicle.trailerCouplerDxM = ElementReader(reader.context, node).number("dx");
    pugi::xml_node trailer = reader.node.child("Trailer").child("TrailerRef");
    if (!trailer) trailer = reader.node.child("Trailer").child("EntityRef"); // esmini's, before 1.3
    if (trailer) vehicle.trailerEntity = ElementReader(reader.context, trailer).textOr("entityRef", "");
}

void parsePerformance(ElementReader reader, Vehicle& vehicle)
{
    const pugi::xml_node node = reader.node.child("Performance");
    if (!node)
    {
        vehicle.performance = defaultVehicle(vehicle.category).performance;
        return reader.context.assumed(reader.node, "Vehicle has no element Performance",
                                      "that of a usual " + vehicle.category + " is taken; add it");
    }
    ElementReader performance(reader.context, node);
    vehicle.performance = {performance.notNegative("maxSpeed"), performance.notNegative("maxAcceleration"),
                           performance.notNegative("maxDeceleration")};
}

/// Tells of a property of esmini's that moves the reference point of a vehicle forward, off its rear axle.
void tellReferencePoint(ElementReader reader, const Properties& properties)
{
    if (!reader.context.options.tolerant) return;
    for (const auto& [name, value] : properties.values)
    {
        if (name != "refpoint_x_offset") continue;
        const std::optional<double> offset = parseNumber(value);
        if (offset && *offset == 0.0) continue;
        reader.context.add(
            {Problem::Kind::approximated,
             {reader.context.place(reader.node),
              "the property refpoint_x_offset=\"" + value + "\" is not in effect",
              "instead: places are those of the rear axle; subtract it from them, or take 0"}});
    }
}

/// Tells of a category that is none: the vehicle looks like a car.
void tellCategory(const ElementReader& reader, const std::string& category)
{
    constexpr std::string_view kCategories = " bicycle bus car motorbike semitractor semitrailer trailer "
                                             "train tram truck van aircraft helicopter ";
    if (!reader.context.options.tolerant || category.empty() ||
        kCategories.find(" " + category + " ") != std::string_view::npos)
        return;
    reader.context.add(
        {Problem::Kind::approximated,
         {reader.context.place(reader.node),
          "vehicleCategory=\"" + category + "\" is no category of vehicles",
          "instead: it is taken for a car; " +
              foundation::didYouMean(category, kCategories, "write car, van, truck or another")}});
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
    tellCategory(reader, vehicle.category);
    reader.textOr("role", ""); // nothing here asks who uses it
    vehicle.model3d = reader.textOr("model3d", "");
    vehicle.massKg = reader.optionalNumber("mass");
    vehicle.box = parseBoundingBox(reader.child("BoundingBox"));
    parsePerformance(reader, vehicle);
    if (const pugi::xml_node node = reader.node.child("Axles"))
        parseAxles({context, node}, vehicle);
    else
    {
        fitDefaultAxles(vehicle);
        context.assumed(reader.node, "Vehicle has no element Axles",
                        "those of a usual " + vehicle.category + " are fitted into its box; add it");
    }
    parseHitch(reader, vehicle);
    vehicle.properties = parseProperties(reader);
    tellReferencePoint(reader, vehicle.properties);
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
    reader.textOr("role", "");
    object.massKg = reader.numberOr("mass", 0.0);
    object.box = parseBoundingBox(reader.child("BoundingBox"));
    object.properties = parseProperties(reader);
    return object;
}

/// Reads the entity of an object, and behind it in `objects` the trailers that are defined in place: the
/// trailer of X is X+, that of X+ is X++, as in esmini.
/// `instead`: what is done without an entry of a catalogue; null: nothing can be.
void parseObject(ElementReader reader, std::size_t index, std::vector<ScenarioObject>& objects,
                 const char* instead = nullptr);

void parseTrailer(ElementReader reader, std::size_t index, std::vector<ScenarioObject>& objects)
{
    ParseContext& context = reader.context;
    pugi::xml_node content = reader.node.child("Trailer").child("CatalogReference");
    // Inline trailers stand in an element of their own, which has the name of the whole.
    if (const pugi::xml_node inner = reader.node.child("Trailer").child("Trailer"))
        for (const char* kind : {"Vehicle", "CatalogReference"})
            if (!content) content = inner.child(kind);
    auto* const vehicle = std::get_if<Vehicle>(&objects[index].object);
    if (!content || !vehicle) return;
    ScenarioObject trailer;
    trailer.source = context.line(content);
    trailer.name = objects[index].name + "+";
    vehicle->trailerEntity = trailer.name;
    objects.push_back(std::move(trailer));
    parseObject({context, content}, objects.size() - 1, objects);
}

void parseObject(ElementReader reader, std::size_t index, std::vector<ScenarioObject>& objects,
                 const char* instead)
{
    if (reader.is("CatalogReference"))
    {
        CatalogVisit visit(reader, instead);
        objects[index].object = Unsupported{reader.context.line(reader.node), "CatalogReference"};
        if (visit.entry()) parseObject({reader.context, visit.entry()}, index, objects);
        return;
    }
    const ParameterScope scope(reader.context, reader.node);
    if (reader.is("Vehicle"))
    {
        objects[index].object = parseVehicle(reader);
        parseTrailer(reader, index, objects);
    }
    else if (reader.is("Pedestrian"))
        objects[index].object = parseSimpleObject<Pedestrian>(reader, "pedestrianCategory");
    else if (reader.is("MiscObject"))
        objects[index].object = parseSimpleObject<MiscObject>(reader, "miscObjectCategory");
    else
        objects[index].object = unsupportedContent(reader, "object");
}

} // namespace

Controller parseObjectController(ElementReader reader)
{
    Controller controller = parseController(reader.onlyChild());
    controller.objectName = reader.textOr("name", "");
    reader.textOr("controllerType", "");
    return controller;
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
        std::string name = reader.text("name");
        properties.values.emplace_back(std::move(name), reader.textAssumed("value"));
    }
    for (pugi::xml_node file : node.children("File"))
        properties.files.push_back(ElementReader(parent.context, file).text("filepath"));
    return properties;
}

std::vector<ScenarioObject> parseScenarioObject(ElementReader reader)
{
    return parseObjectContent(reader, reader.has("name") ? reader.name() : reader.text("name"), nullptr);
}

std::vector<ScenarioObject> parseObjectContent(ElementReader reader, const std::string& name,
                                               const char* instead)
{
    std::vector<ScenarioObject> objects(1);
    objects[0].source = reader.context.line(reader.node);
    objects[0].name = name;
    bool hasObject = false;
    for (pugi::xml_node node : reader.node.children())
    {
        if (node.type() != pugi::node_element) continue;
        ElementReader content(reader.context, node);
        if (content.is("ObjectController"))
        {
            if (content.hasContent()) objects[0].controllers.push_back(parseObjectController(content));
        }
        else if (hasObject)
            reader.context.foreign(node, std::string("the element ") + node.name());
        else
        {
            parseObject(content, 0, objects, instead);
            hasObject = true;
        }
    }
    if (!hasObject) reader.context.invalid(reader.node, "the ScenarioObject is empty", "add a Vehicle");
    return objects;
}

} // namespace simulation
