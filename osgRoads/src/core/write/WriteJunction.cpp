// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.7, 12 (junctions).
#include <string>

#include "ElementWriters.h"
#include "XmlFields.h"

namespace osgRoads::core
{

void writeJunction(pugi::xml_node root, const Junction& junction)
{
    pugi::xml_node node = root.append_child("junction");
    set(node, "id", junction.id);
    set(node, "name", junction.name);
    set(node, "type",
        junction.type == JunctionType::common ? "default" : keyword(kJunctionTypes, junction.type));
    for (const JunctionConnection& connection : junction.connections)
    {
        pugi::xml_node entry = node.append_child("connection");
        set(entry, "id", connection.id);
        set(entry, "incomingRoad", connection.incomingRoadId);
        set(entry, "connectingRoad", connection.connectingRoadId);
        set(entry, "contactPoint", keyword(kContactPoints, connection.contactPoint));
        for (const JunctionConnection::LaneLink& link : connection.laneLinks)
        {
            const pugi::xml_node lane = entry.append_child("laneLink");
            set(lane, "from", link.from);
            set(lane, "to", link.to);
        }
    }
    for (const Junction::Priority& priority : junction.priorities)
    {
        const pugi::xml_node entry = node.append_child("priority");
        set(entry, "high", priority.high);
        set(entry, "low", priority.low);
    }
    for (const std::string& id : junction.controllerIds)
        set(node.append_child("controller"), "id", id);
}

} // namespace osgRoads::core
