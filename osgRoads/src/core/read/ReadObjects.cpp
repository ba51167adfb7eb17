// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 13 (objects).
#include <algorithm>
#include <utility>

#include <osgRoads/core/query/MarkStrokes.h>

#include "ElementReaders.h"

namespace osgRoads::core
{

namespace
{

ObjectOutline readOutline(NodeReader& element)
{
    ObjectOutline outline;
    element.has("id");
    outline.isClosed = !element.has("closed") || element.flag("closed");
    outline.isOuter = !element.has("outer") || element.flag("outer");
    outline.fillType = element.text("fillType");
    outline.laneType = element.text("laneType");
    element.each("cornerRoad",
                 [&](NodeReader& corner)
                 {
                     outline.corners.push_back({true, corner.number("s"), corner.number("t"),
                                                corner.number("dz"), corner.numberOr("height", 0.0),
                                                corner.integer("id", -1)});
                 });
    element.each("cornerLocal",
                 [&](NodeReader& corner)
                 {
                     outline.corners.push_back({false, corner.number("u"), corner.number("v"),
                                                corner.number("z"), corner.numberOr("height", 0.0),
                                                corner.integer("id", -1)});
                 });
    return outline;
}

ObjectRepeat readRepeat(NodeReader& element)
{
    ObjectRepeat repeat;
    repeat.s = element.number("s");
    repeat.length = element.number("length");
    repeat.distance = element.number("distance");
    repeat.tStart = element.number("tStart");
    repeat.tEnd = element.number("tEnd");
    repeat.zOffsetStart = element.numberOr("zOffsetStart", 0.0);
    repeat.zOffsetEnd = element.numberOr("zOffsetEnd", 0.0);
    repeat.heightStart = element.optionalNumber("heightStart");
    repeat.heightEnd = element.optionalNumber("heightEnd");
    repeat.widthStart = element.optionalNumber("widthStart");
    repeat.widthEnd = element.optionalNumber("widthEnd");
    repeat.lengthStart = element.optionalNumber("lengthStart");
    repeat.lengthEnd = element.optionalNumber("lengthEnd");
    repeat.radiusStart = element.optionalNumber("radiusStart");
    repeat.radiusEnd = element.optionalNumber("radiusEnd");
    if (repeat.length < 0.0 || repeat.distance < 0.0)
    {
        element.mistake("repeat has a negative length or distance", "write 0 or more; 0 is used");
        repeat.length = std::max(repeat.length, 0.0);
        repeat.distance = std::max(repeat.distance, 0.0);
    }
    return repeat;
}

void readSizes(NodeReader& element, RoadObject& object)
{
    object.length = element.numberOr("length", 0.0);
    object.radius = element.numberOr("radius", 0.0);
    for (double* size : {&object.length, &object.width, &object.radius})
    {
        if (*size >= 0.0) continue;
        element.mistake("object " + object.id + " has a negative size", "write 0 or more; 0 is used");
        *size = 0.0;
    }
}

bool hasCorner(const RoadObject& object, int id)
{
    return std::any_of(object.outlines.begin(), object.outlines.end(),
                       [id](const ObjectOutline& outline)
                       {
                           return std::any_of(outline.corners.begin(), outline.corners.end(),
                                              [id](const OutlineCorner& corner) { return corner.id == id; });
                       });
}

/// Reads the corners of a marking. Without two of them it needs a side.
void readMarkedCorners(NodeReader& element, const RoadObject& object, ObjectMarking& marking)
{
    element.each("cornerReference",
                 [&](NodeReader& corner)
                 {
                     const int id = corner.integer("id", -1);
                     if (hasCorner(object, id))
                         marking.corners.push_back(id);
                     else
                         corner.mistake("a marking of object " + object.id + " names corner " +
                                            std::to_string(id) + ", which none of its outlines has",
                                        "give a corner that id; this one is passed over");
                 });
    if (marking.corners.size() < 2 && marking.side == ObjectSide::none)
        element.mistake("a marking of object " + object.id + " has neither a side nor two corners",
                        "write side or cornerReference; it is not painted");
}

ObjectMarking readMarking(NodeReader& element, const RoadObject& object)
{
    ObjectMarking marking;
    marking.side = element.choice("side", kObjectSides, ObjectSide::none);
    marking.colour = element.choice("color", kMarkColours, MarkColour::white);
    const MarkWeight weight = element.choice("weight", kMarkWeights, MarkWeight::standard);
    marking.width = element.numberOr("width", 0.0);
    marking.lineLength = element.number("lineLength");
    marking.spaceLength = element.number("spaceLength");
    marking.startOffset = element.number("startOffset");
    marking.stopOffset = element.number("stopOffset");
    element.has("zOffset"); // paint lies on the road
    for (double* size : {&marking.width, &marking.lineLength, &marking.spaceLength, &marking.startOffset,
                         &marking.stopOffset})
    {
        if (*size >= 0.0) continue;
        element.mistake("a marking of object " + object.id + " has a negative width, length or offset",
                        "write 0 or more; 0 is used");
        *size = 0.0;
    }
    if (marking.width == 0.0) marking.width = weight == MarkWeight::bold ? kBoldMarkWidthM : kMarkWidthM;
    readMarkedCorners(element, object, marking);
    return marking;
}

RoadObject readObject(NodeReader& element)
{
    RoadObject object;
    readItem(element, object);
    object.headingRad = element.numberOr("hdg", 0.0);
    object.validLength = element.numberOr("validLength", 0.0);
    object.isPerpendicularToRoad = element.flag("perpToRoad");
    readSizes(element, object);
    const auto addOutline = [&](NodeReader& outline) { object.outlines.push_back(readOutline(outline)); };
    element.each("outline", addOutline); // up to 1.4
    element.each("outlines", [&](NodeReader& outlines) { outlines.each("outline", addOutline); });
    element.each("markings",
                 [&](NodeReader& markings)
                 {
                     markings.each("marking", [&](NodeReader& marking)
                                   { object.markings.push_back(readMarking(marking, object)); });
                 });
    element.each("repeat", [&](NodeReader& repeat) { object.repeats.push_back(readRepeat(repeat)); });
    element.each("parkingSpace",
                 [&](NodeReader& space)
                 {
                     object.parkingAccess = space.text("access");
                     space.has("restrictions");
                 });
    return object;
}

RoadStructure readStructure(NodeReader& element, StructureKind kind)
{
    RoadStructure structure;
    structure.kind = kind;
    structure.line = element.line();
    structure.id = element.text("id");
    structure.name = element.text("name");
    structure.type = element.text("type");
    structure.s = element.number("s");
    structure.length = element.number("length");
    if (kind == StructureKind::tunnel)
    {
        structure.lighting = element.numberOr("lighting", 0.0);
        structure.daylight = element.numberOr("daylight", 0.0);
    }
    structure.validities = readValidities(element);
    return structure;
}

void readStructureOn(NodeReader& element, StructureKind kind, Road& into)
{
    into.structures.push_back(readStructure(element, kind));
    const RoadStructure& structure = into.structures.back();
    const std::string name = std::string(element.node.name()) + " " + structure.id;
    reportOffRoad(element, name, structure.s, into);
    if (structure.length <= 0.0 && element.has("length"))
        element.mistake(name + " is " + shortNumber(structure.length) + " m long",
                        "write a length above 0; it is not drawn");
}

} // namespace

std::vector<LaneValidity> readValidities(NodeReader& element)
{
    std::vector<LaneValidity> validities;
    element.each("validity",
                 [&](NodeReader& validity) {
                     validities.push_back({validity.integer("fromLane", 0), validity.integer("toLane", 0)});
                 });
    return validities;
}

void readItem(NodeReader& element, RoadItem& item)
{
    item.line = element.line();
    item.id = element.id("id");
    item.name = element.text("name");
    item.type = element.text("type");
    item.subtype = element.text("subtype");
    item.s = element.number("s");
    item.t = element.number("t");
    item.zOffset = element.numberOr("zOffset", 0.0);
    item.orientation = readOrientation(element);
    item.pitchRad = element.numberOr("pitch", 0.0);
    item.rollRad = element.numberOr("roll", 0.0);
    item.width = element.numberOr("width", 0.0);
    item.height = element.numberOr("height", 0.0);
    item.isDynamic = element.flag("dynamic");
    item.validities = readValidities(element);
}

void reportOffRoad(NodeReader& element, const std::string& name, double s, const Road& road)
{
    if (s < 0.0 || s > road.length + 0.01)
        element.mistake(name + " is at s " + shortNumber(s) + ", not on the road", "correct s");
}

void readObjects(NodeReader& road, Road& into)
{
    road.each("objects",
              [&](NodeReader& objects)
              {
                  objects.each("object",
                               [&](NodeReader& element)
                               {
                                   into.objects.push_back(readObject(element));
                                   const RoadObject& object = into.objects.back();
                                   reportOffRoad(element, "object " + object.id, object.s, into);
                               });
                  objects.each("bridge", [&](NodeReader& element)
                               { readStructureOn(element, StructureKind::bridge, into); });
                  objects.each("tunnel", [&](NodeReader& element)
                               { readStructureOn(element, StructureKind::tunnel, into); });
              });
}

} // namespace osgRoads::core
