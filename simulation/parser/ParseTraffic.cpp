// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "simulation/parser/CatalogShelf.h"
#include "simulation/parser/ElementParsers.h"
#include "simulation/scenario/DefaultVehicle.h"

namespace simulation
{
namespace
{

constexpr int kMostVehicles = 1000; ///< of one action

/// A whole number, at most kMostVehicles; more is told.
int vehicleCount(ElementReader& reader, double wanted)
{
    if (wanted > kMostVehicles)
        reader.context.unsupported(reader.node, "a count of vehicles above " + std::to_string(kMostVehicles),
                                   std::to_string(kMostVehicles) + " are there");
    return static_cast<int>(std::clamp(wanted, 0.0, static_cast<double>(kMostVehicles)));
}

Controller parseDriver(ElementReader reader)
{
    ElementReader content = reader.onlyChild();
    return content.is("ObjectController") ? parseObjectController(content) : parseController(content);
}

/// 1.0 to 1.2: categories and controllers, each with weights.
TrafficMix parseDefinition(ElementReader reader)
{
    reader.allowChildren(
        {"VehicleCategoryDistribution", "ControllerDistribution", "VehicleRoleDistribution"});
    TrafficMix mix;
    reader.textOr("name", "");
    ElementReader categories = reader.child("VehicleCategoryDistribution");
    for (pugi::xml_node node : categories.node.children("VehicleCategoryDistributionEntry"))
    {
        ElementReader entry(reader.context, node);
        TrafficKind kind{entry.notNegative("weight"), {}};
        kind.object.source = reader.context.line(node);
        kind.object.object = defaultVehicle(entry.text("category"));
        mix.kinds.push_back(std::move(kind));
    }
    for (pugi::xml_node node :
         reader.node.child("ControllerDistribution").children("ControllerDistributionEntry"))
    {
        ElementReader entry(reader.context, node);
        const double weight = entry.notNegative("weight");
        mix.drivers.push_back({weight, parseDriver(entry)});
    }
    return mix;
}

/// 1.3: whole objects, each with weights.
TrafficMix parseDistribution(ElementReader reader)
{
    reader.allowChildren({"TrafficDistributionEntry"});
    TrafficMix mix;
    for (pugi::xml_node outer : reader.node.children("TrafficDistributionEntry"))
    {
        ElementReader entry(reader.context, outer);
        const double share = entry.notNegative("weight");
        ElementReader entities = entry.child("EntityDistribution");
        for (pugi::xml_node inner : entities.node.children("EntityDistributionEntry"))
        {
            ElementReader one(reader.context, inner);
            const double weight = one.notNegative("weight");
            auto objects =
                parseObjectContent(one.child("ScenarioObjectTemplate"), "template", "a usual car is taken");
            if (std::holds_alternative<Unsupported>(objects.front().object))
                objects.front().object = defaultVehicle("car");
            mix.kinds.push_back({share * weight, std::move(objects.front())}); // trailers are left out
        }
    }
    return mix;
}

TrafficMix parseMix(ElementReader& reader)
{
    if (const pugi::xml_node node = reader.node.child("TrafficDistribution"))
        return parseDistribution({reader.context, node});
    if (const pugi::xml_node node = reader.node.child("TrafficDefinition"))
        return parseDefinition({reader.context, node});
    return {};
}

/// From 1.2 on `speed`; `velocity` is its older name.
std::optional<double> parseSpeed(ElementReader& reader)
{
    const auto speed = reader.optionalNumber("speed");
    return speed ? speed : reader.optionalNumber("velocity");
}

TrafficSource parseSource(ElementReader reader)
{
    reader.allowChildren({"Position", "TrafficDefinition", "TrafficDistribution"});
    TrafficSource source;
    source.perSecond = reader.notNegative("rate");
    source.radiusM = reader.notNegative("radius");
    source.speedMps = parseSpeed(reader);
    source.position = parsePosition(reader.child("Position"));
    source.mix = parseMix(reader);
    return source;
}

TrafficSink parseSink(ElementReader reader)
{
    reader.allowChildren({"Position", "TrafficDefinition"});
    TrafficSink sink;
    if (reader.has("rate")) sink.perSecond = reader.notNegative("rate");
    sink.radiusM = reader.notNegative("radius");
    sink.position = parsePosition(reader.child("Position"));
    for (const TrafficKind& kind : parseMix(reader).kinds)
        if (const auto* vehicle = std::get_if<Vehicle>(&kind.object.object))
            sink.categories.push_back(vehicle->category);
    return sink;
}

std::optional<SpeedRange> parseSpeedRange(ElementReader& reader)
{
    if (const pugi::xml_node node = reader.node.child("InitialSpeedRange"))
    {
        ElementReader range(reader.context, node);
        return SpeedRange{range.number("lowerLimit"), range.number("upperLimit")};
    }
    const auto velocity = parseSpeed(reader);
    return velocity ? std::optional(SpeedRange{*velocity, *velocity}) : std::nullopt;
}

/// 1.0 calls the central entity CentralSwarmObject.
TrafficSwarm parseSwarm(ElementReader reader)
{
    reader.allowChildren({"CentralObject", "CentralSwarmObject", "TrafficDefinition", "TrafficDistribution",
                          "InitialSpeedRange", "DirectionOfTravelDistribution"});
    TrafficSwarm swarm;
    const bool isOld = static_cast<bool>(reader.node.child("CentralSwarmObject"));
    ElementReader entity = isOld ? reader.child("CentralSwarmObject") : reader.child("CentralObject");
    swarm.central = parseEntityRef(entity, "entityRef");
    swarm.semiMajorM = reader.notNegative("semiMajorAxis");
    swarm.semiMinorM = reader.notNegative("semiMinorAxis");
    swarm.innerRadiusM = reader.notNegative("innerRadius");
    swarm.offsetM = reader.numberOr("offset", 0.0);
    swarm.count = vehicleCount(reader, reader.notNegative("numberOfVehicles"));
    swarm.speed = parseSpeedRange(reader);
    if (const pugi::xml_node node = reader.node.child("DirectionOfTravelDistribution"))
    {
        ElementReader directions(reader.context, node);
        swarm.sameDirection = directions.notNegative("same");
        swarm.oppositeDirection = directions.notNegative("opposite");
    }
    swarm.mix = parseMix(reader);
    return swarm;
}

std::vector<int> parseLanes(ElementReader& reader)
{
    std::vector<int> lanes;
    for (pugi::xml_node node : reader.node.children("Lane"))
        lanes.push_back(static_cast<int>(ElementReader(reader.context, node).number("id")));
    return lanes;
}

/// From each RoadCursor to the next one on the same road; the last one reaches as far as `length` says.
void addStretches(ElementReader range, std::vector<RoadStretch>& stretches)
{
    const std::optional<double> length = range.optionalNumber("length");
    std::vector<RoadStretch> cursors;
    for (pugi::xml_node node : range.node.children("RoadCursor"))
    {
        ElementReader cursor(range.context, node);
        RoadStretch stretch;
        stretch.roadId = cursor.text("roadId");
        stretch.fromM = cursor.numberOr("s", 0.0);
        stretch.lanes = parseLanes(cursor);
        cursors.push_back(std::move(stretch));
    }
    if (cursors.empty()) range.context.invalid(range.node, "a RoadRange has no RoadCursor", "add one");
    for (std::size_t i = 0; i < cursors.size(); ++i)
    {
        const bool isLast = i + 1 == cursors.size();
        if (isLast && i > 0 && !length && cursors[i].roadId == cursors[i - 1].roadId) break; // an end
        if (!isLast && cursors[i + 1].roadId == cursors[i].roadId) cursors[i].toM = cursors[i + 1].fromM;
        if (isLast && length) cursors[i].toM = cursors[i].fromM + *length;
        stretches.push_back(cursors[i]);
    }
}

TrafficArea parseArea(ElementReader reader)
{
    reader.allowChildren({"TrafficArea", "TrafficDefinition", "TrafficDistribution"});
    TrafficArea area;
    area.isContinuous = reader.flagOr("continuous", false);
    area.count = vehicleCount(reader, reader.notNegative("numberOfEntities"));
    ElementReader where = reader.child("TrafficArea");
    where.allowChildren({"Polygon", "RoadRange"});
    if (const pugi::xml_node polygon = where.node.child("Polygon"))
    {
        ElementReader shape(reader.context, polygon);
        for (pugi::xml_node node : polygon.children("Position"))
            area.corners.push_back(parsePosition({reader.context, node}));
        if (area.corners.size() < 3)
            reader.context.invalid(polygon, "a Polygon has less than three Positions", "add some");
    }
    for (pugi::xml_node node : where.node.children("RoadRange"))
        addStretches({reader.context, node}, area.stretches);
    if (area.corners.empty() && area.stretches.empty())
        reader.context.invalid(where.node, "the TrafficArea is empty", "add a Polygon or a RoadRange");
    area.mix = parseMix(reader);
    return area;
}

} // namespace

GlobalAction parseTrafficAction(ElementReader reader)
{
    TrafficAction action;
    action.source = reader.context.line(reader.node);
    action.name = reader.textOr("trafficName", "");
    ElementReader content = reader.onlyChild();
    if (content.is("TrafficSourceAction"))
        action.content = parseSource(content);
    else if (content.is("TrafficSinkAction"))
        action.content = parseSink(content);
    else if (content.is("TrafficSwarmAction"))
        action.content = parseSwarm(content);
    else if (content.is("TrafficAreaAction"))
        action.content = parseArea(content);
    else if (content.is("TrafficStopAction"))
        action.content = TrafficStop{};
    else
        return unsupportedContent(content, "action");
    if (!reader.context.hasRoads)
        reader.context.unsupported(reader.node, "traffic without a LogicFile", "no traffic is made");
    return action;
}

} // namespace simulation
