// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 12 (junctions).
#include <utility>

#include "ElementReaders.h"

namespace osgRoads::core
{

namespace
{

JunctionConnection readConnection(NodeReader& element)
{
    JunctionConnection connection;
    connection.line = element.line();
    connection.id = element.text("id");
    element.has("type");
    connection.incomingRoadId = element.text("incomingRoad");
    connection.connectingRoadId =
        element.has("linkedRoad") ? element.text("linkedRoad") : element.text("connectingRoad");
    element.has("connectingRoad");
    connection.contactPoint = element.choice("contactPoint", kContactPoints, ContactPoint::start);
    element.each("laneLink",
                 [&](NodeReader& link)
                 {
                     link.has("overlapZone");
                     connection.laneLinks.push_back({link.integer("from", 0), link.integer("to", 0)});
                 });
    return connection;
}

} // namespace

Junction readJunction(NodeReader& element)
{
    Junction junction;
    junction.line = element.line();
    junction.id = element.id("id");
    junction.name = element.text("name");
    element.context.subject = "junction " + junction.id;
    junction.type = element.choice("type", kJunctionTypes, JunctionType::common);
    junction.mainRoadId = element.text("mainRoad");
    junction.sStart = element.numberOr("sStart", 0.0);
    junction.sEnd = element.numberOr("sEnd", 0.0);
    element.has("orientation");
    element.each("connection",
                 [&](NodeReader& connection) { junction.connections.push_back(readConnection(connection)); });
    element.each("priority",
                 [&](NodeReader& priority) {
                     junction.priorities.push_back({priority.text("high"), priority.text("low")});
                 });
    element.each("controller",
                 [&](NodeReader& controller)
                 {
                     junction.controllerIds.push_back(controller.id("id"));
                     controller.has("type");
                     controller.has("sequence");
                 });
    element.context.subject.clear();
    return junction;
}

} // namespace osgRoads::core
