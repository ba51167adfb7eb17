// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.7, 8 (roads), 13.1 (objects), 13.12 and 13.13 (tunnels, bridges).
#include "ElementWriters.h"
#include "XmlFields.h"

namespace osgRoads::core
{

namespace
{

void writeLink(pugi::xml_node links, const char* name, const std::optional<RoadLink>& link)
{
    if (!link) return;
    const pugi::xml_node node = links.append_child(name);
    set(node, "elementType", link->isJunction ? "junction" : "road");
    set(node, "elementId", link->elementId);
    if (!link->isJunction) set(node, "contactPoint", keyword(kContactPoints, link->contactPoint));
}

void writeKinds(pugi::xml_node roadNode, const std::vector<RoadKind>& kinds)
{
    for (const RoadKind& kind : kinds)
    {
        pugi::xml_node node = roadNode.append_child("type");
        set(node, "s", kind.s);
        set(node, "type", kind.type);
        if (!kind.country.empty()) set(node, "country", kind.country);
        if (!kind.metresPerSecond) continue;
        const pugi::xml_node speed = node.append_child("speed");
        set(speed, "max", *kind.metresPerSecond);
        set(speed, "unit", "m/s");
    }
}

void writeObject(pugi::xml_node objects, const RoadObject& object)
{
    const pugi::xml_node node = objects.append_child("object");
    set(node, "id", object.id);
    set(node, "name", object.name);
    set(node, "type", object.type);
    set(node, "subtype", object.subtype);
    writePlace(node, object);
    set(node, "hdg", object.headingRad);
    set(node, "length", object.length);
    set(node, "width", object.width);
    set(node, "height", object.height);
}

void writeObjects(pugi::xml_node roadNode, const Road& road)
{
    if (road.structures.empty() && road.objects.empty()) return;
    pugi::xml_node objects = roadNode.append_child("objects");
    for (const RoadObject& object : road.objects)
        writeObject(objects, object);
    for (const RoadStructure& structure : road.structures)
    {
        const bool isTunnel = structure.kind == StructureKind::tunnel;
        const pugi::xml_node node = objects.append_child(isTunnel ? "tunnel" : "bridge");
        set(node, "id", structure.id);
        set(node, "name", structure.name);
        set(node, "type", structure.type);
        set(node, "s", structure.s);
        set(node, "length", structure.length);
        if (!isTunnel) continue;
        set(node, "lighting", structure.lighting);
        set(node, "daylight", structure.daylight);
    }
}

} // namespace

void writeRoad(pugi::xml_node root, const Road& road)
{
    pugi::xml_node node = root.append_child("road");
    set(node, "name", road.name);
    set(node, "length", road.length);
    set(node, "id", road.id);
    set(node, "junction", road.junctionId.empty() ? "-1" : road.junctionId);
    set(node, "rule", road.isLeftHandTraffic ? "LHT" : "RHT");
    pugi::xml_node links = node.append_child("link");
    writeLink(links, "predecessor", road.predecessor);
    writeLink(links, "successor", road.successor);
    writeKinds(node, road.kinds);
    writePlanView(node, road.referenceLine);
    writeProfile(node.append_child("elevationProfile"), "elevation", "s", road.elevation);
    writeProfile(node.append_child("lateralProfile"), "superelevation", "s", road.superelevationRad);
    writeLanes(node, road);
    writeObjects(node, road);
    writeSignals(node, road);
}

} // namespace osgRoads::core
