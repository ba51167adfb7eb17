// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 10 (roads).
#include <utility>

#include "ElementReaders.h"

namespace osgRoads::core
{

namespace
{

std::optional<RoadLink> readLink(NodeReader& links, const char* end)
{
    std::optional<RoadLink> link;
    const auto read = [&](NodeReader& element)
    {
        RoadLink found;
        found.line = element.line();
        found.elementId = element.id("elementId");
        const std::string type = element.text("elementType");
        found.isJunction = type == "junction";
        if (type != "junction" && type != "road")
            element.mistake(std::string(end) + "/elementType has the unknown value \"" + type.substr(0, 40) +
                                "\"",
                            "write road or junction; road is used");
        if (!found.isJunction && !element.has("contactPoint") && !element.has("elementS"))
            element.mistake(std::string("the ") + end + " has no contactPoint",
                            "write start or end; start is used");
        found.contactPoint = element.choice("contactPoint", kContactPoints, ContactPoint::start);
        found.elementS = element.optionalNumber("elementS");
        element.has("elementDir");
        link = found;
    };
    links.each(end, read);
    return link;
}

void readKinds(NodeReader& element, Road& road)
{
    element.each("type",
                 [&](NodeReader& type)
                 {
                     RoadKind kind;
                     kind.s = type.number("s");
                     kind.type = type.text("type");
                     kind.country = type.text("country");
                     type.each("speed", [&](NodeReader& speed) { kind.metresPerSecond = readSpeed(speed); });
                     road.kinds.push_back(std::move(kind));
                 });
    sortByStart(element, "type", road.kinds);
}

double readLength(NodeReader& element)
{
    const double length = element.number("length");
    if (length > kLongestRoadM)
        element.mistake("the road is " + shortNumber(length) + " m long",
                        "correct its length: longer than 1e6 m it is left out");
    else if (!(length > 0.0) && element.has("length"))
        element.mistake("the road is " + shortNumber(length) + " m long",
                        "write a length above 0; the road is left out");
    return length;
}

bool readTrafficSide(NodeReader& element)
{
    const std::string rule = element.text("rule");
    if (!rule.empty() && rule != "RHT" && rule != "LHT")
        element.mistake("road/rule has the unknown value \"" + rule.substr(0, 40) + "\"",
                        "write RHT or LHT; RHT is used");
    return rule == "LHT";
}

} // namespace

Road readRoad(NodeReader& element)
{
    Road road;
    road.line = element.line();
    road.id = element.id("id");
    element.context.subject = "road " + road.id;
    road.name = element.text("name");
    road.junctionId = element.text("junction");
    if (road.junctionId == "-1") road.junctionId.clear();
    road.isLeftHandTraffic = readTrafficSide(element);
    road.length = readLength(element);
    const bool isLengthSound = road.length > 0.0 && road.length <= kLongestRoadM;
    element.each("link",
                 [&](NodeReader& links)
                 {
                     road.predecessor = readLink(links, "predecessor");
                     road.successor = readLink(links, "successor");
                 });
    readKinds(element, road);
    if (isLengthSound)
        readPlanView(element, road);
    else
        element.passOver("planView");
    element.each("elevationProfile",
                 [&](NodeReader& profile) { road.elevation = profile.profile("elevation", "s"); });
    readLateralProfile(element, road);
    readLanes(element, road);
    readObjects(element, road);
    readSignals(element, road);
    element.each("surface", [](NodeReader&) {}); // often empty; CRG in it is not supported
    road.isUsable = isLengthSound && !road.referenceLine.isEmpty();
    element.context.subject.clear();
    return road;
}

} // namespace osgRoads::core
