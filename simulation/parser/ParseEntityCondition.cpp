// SPDX-License-Identifier: Apache-2.0
#include <foundation/NearestWord.h>

#include "simulation/parser/ElementParsers.h"

namespace simulation
{
namespace
{

TimeHeadwayCondition parseTimeHeadway(ElementReader reader)
{
    return {parseEntityRef(reader, "entityRef"), reader.bound("value"), reader.choice("rule", kRules),
            parseDistanceMeasure(reader)};
}

TimeToCollisionCondition parseTimeToCollision(ElementReader reader)
{
    TimeToCollisionCondition condition;
    condition.seconds = reader.bound("value");
    condition.rule = reader.choice("rule", kRules);
    condition.measure = parseDistanceMeasure(reader);
    ElementReader target = reader.child("TimeToCollisionConditionTarget");
    if (const pugi::xml_node node = target.node.child("EntityRef"))
    {
        ElementReader entity(reader.context, node);
        condition.target = parseEntityRef(entity, "entityRef");
    }
    else
        condition.target = parsePosition(target.child("Position"));
    return condition;
}

DistanceCondition parseRelativeDistance(ElementReader reader)
{
    return {parseEntityRef(reader, "entityRef"), reader.bound("value"), reader.choice("rule", kRules),
            parseDistanceMeasure(reader)};
}

DistanceCondition parseDistance(ElementReader reader)
{
    return {parsePosition(reader.child("Position")), reader.bound("value"), reader.choice("rule", kRules),
            parseDistanceMeasure(reader)};
}

SpeedCondition parseSpeed(ElementReader reader, const std::string& entity)
{
    return {entity, reader.bound("value"), reader.choice("rule", kRules),
            reader.choiceOr("direction", kDirections, Direction::total)};
}

CollisionCondition parseCollision(ElementReader reader)
{
    reader.allowChildren({"EntityRef", "ByType"});
    CollisionCondition condition;
    if (const pugi::xml_node node = reader.node.child("EntityRef"))
    {
        ElementReader entity(reader.context, node);
        condition.entity = parseEntityRef(entity, "entityRef");
    }
    else if (const pugi::xml_node type = reader.node.child("ByType"))
        condition.type = ElementReader(reader.context, type).text("type");
    return condition;
}

AngleCondition parseAngle(ElementReader reader, const std::string& entity)
{
    return {entity, reader.choice("angleType", kAngleTypes), reader.number("angle"),
            reader.notNegative("angleTolerance"),
            reader.choiceOr("coordinateSystem", kDistanceFrames, DistanceFrame::world)};
}

RelativeClearanceCondition parseClearance(ElementReader reader)
{
    reader.allowChildren({"RelativeLaneRange", "EntityRef"});
    RelativeClearanceCondition condition;
    condition.forwardM = reader.has("distanceForward") ? reader.notNegative("distanceForward") : 0.0;
    condition.backwardM = reader.has("distanceBackward") ? reader.notNegative("distanceBackward") : 0.0;
    condition.isFreespace = reader.flagOr("freeSpace", false);
    condition.hasOppositeLanes = reader.flagOr("oppositeLanes", false);
    const auto lane = [](const std::optional<double>& value)
    { return value ? std::optional(static_cast<int>(*value)) : std::nullopt; };
    for (pugi::xml_node node : reader.node.children("RelativeLaneRange"))
    {
        ElementReader range(reader.context, node);
        condition.lanes.push_back({lane(range.optionalNumber("from")), lane(range.optionalNumber("to"))});
    }
    for (pugi::xml_node node : reader.node.children("EntityRef"))
        for (const std::string& name : parseEntityRefs({reader.context, node}))
            condition.entities.push_back(name);
    return condition;
}

EntityConditionContent parseEntityContent(ElementReader reader)
{
    using Kind = LastingCondition::Kind;
    if (reader.is("TimeHeadwayCondition")) return parseTimeHeadway(reader);
    if (reader.is("TimeToCollisionCondition")) return parseTimeToCollision(reader);
    if (reader.is("RelativeDistanceCondition")) return parseRelativeDistance(reader);
    if (reader.is("DistanceCondition")) return parseDistance(reader);
    if (reader.is("TraveledDistanceCondition")) return TraveledDistanceCondition{reader.bound("value")};
    if (reader.is("ReachPositionCondition"))
        return ReachPositionCondition{parsePosition(reader.child("Position")),
                                      reader.notNegative("tolerance")};
    if (reader.is("SpeedCondition")) return parseSpeed(reader, "");
    if (reader.is("RelativeSpeedCondition")) return parseSpeed(reader, parseEntityRef(reader, "entityRef"));
    if (reader.is("AccelerationCondition"))
        return AccelerationCondition{reader.bound("value"), reader.choice("rule", kRules),
                                     reader.choiceOr("direction", kDirections, Direction::total)};
    if (reader.is("StandStillCondition"))
        return LastingCondition{Kind::standStill, reader.notNegative("duration")};
    if (reader.is("OffroadCondition")) return LastingCondition{Kind::offroad, reader.notNegative("duration")};
    if (reader.is("EndOfRoadCondition"))
        return LastingCondition{Kind::endOfRoad, reader.notNegative("duration")};
    if (reader.is("CollisionCondition")) return parseCollision(reader);
    if (reader.is("AngleCondition")) return parseAngle(reader, "");
    if (reader.is("RelativeAngleCondition")) return parseAngle(reader, parseEntityRef(reader, "entityRef"));
    if (reader.is("RelativeClearanceCondition")) return parseClearance(reader);
    return unsupportedContent(reader, "condition");
}

} // namespace

std::string parseEntityRef(ElementReader& reader, const char* attribute)
{
    std::string name = reader.text(attribute);
    if (reader.node && !reader.context.entityNames.contains(name))
    {
        const auto like =
            foundation::nearestWord(name, reader.context.entityNames,
                                    [](const std::string& known) { return std::string_view(known); });
        reader.context.invalid(reader.node, "the entity " + name + " does not exist",
                               like ? "did you mean " + std::string(*like) + "?"
                                    : std::string("name one of Entities"));
    }
    return name;
}

std::vector<std::string> parseEntityRefs(ElementReader reference)
{
    const auto selection = reference.context.selections.find(reference.textOr("entityRef", ""));
    if (selection != reference.context.selections.end()) return selection->second;
    return {parseEntityRef(reference, "entityRef")};
}

/// `alongRoute` = `true` (1.0; deprecated from 1.1 on) stands for the frame of the lane, along it, as in
/// esmini.
DistanceMeasure parseDistanceMeasure(ElementReader& reader)
{
    DistanceMeasure measure;
    measure.isFreespace = reader.flagOr("freespace", false);
    if (reader.flagOr("alongRoute", false))
        measure = {DistanceFrame::lane, DistanceKind::longitudinal, measure.isFreespace};
    measure.frame = reader.choiceOr("coordinateSystem", kDistanceFrames, measure.frame);
    measure.kind = reader.choiceOr("relativeDistanceType", kDistanceKinds, measure.kind);
    return measure;
}

EntityCondition parseEntityCondition(ElementReader reader)
{
    reader.allowChildren({"TriggeringEntities", "EntityCondition"});
    EntityCondition condition;
    ElementReader entities = reader.child("TriggeringEntities");
    condition.isForAll = entities.choiceAssumed("triggeringEntitiesRule", kTriggeringRules);
    for (pugi::xml_node node : entities.node.children("EntityRef"))
    {
        for (const std::string& name : parseEntityRefs({reader.context, node}))
            condition.entities.push_back(name);
    }
    if (condition.entities.empty() && entities.node)
        reader.context.invalid(entities.node, "TriggeringEntities has no EntityRef", "name an entity");
    condition.content = parseEntityContent(reader.child("EntityCondition").onlyChild());
    return condition;
}

} // namespace simulation
