// SPDX-License-Identifier: Apache-2.0
#include <unordered_set>

#include "ElementReaders.h"

namespace osgRoads::core
{

namespace
{

void resolve(RoadNetwork& network, ReadContext& context, std::optional<RoadLink>& link, const char* end)
{
    if (!link) return;
    link->index =
        link->isJunction ? network.junctionIndex(link->elementId) : network.roadIndex(link->elementId);
    if (link->index >= 0) return;
    context.mistake(link->line,
                    std::string("the ") + end + " is " + (link->isJunction ? "junction " : "road ") +
                        link->elementId + ", which is not there",
                    "correct the id or remove the link");
}

/// A road that begins and ends at its own start, or at its own end, leads nowhere.
void checkCircle(const Road& road, ReadContext& context, const std::optional<RoadLink>& link,
                 ContactPoint own)
{
    if (!link || link->isJunction || link->elementId != road.id || link->contactPoint != own) return;
    context.mistake(link->line,
                    std::string("the ") + (own == ContactPoint::start ? "start" : "end") +
                        " of the road is linked to itself",
                    "link it to another road, or to its other end");
}

void resolveConnections(RoadNetwork& network, ReadContext& context, Junction& junction)
{
    for (JunctionConnection& connection : junction.connections)
    {
        connection.incomingRoad = network.roadIndex(connection.incomingRoadId);
        connection.connectingRoad = network.roadIndex(connection.connectingRoadId);
        const bool needsIncoming =
            junction.type != JunctionType::isVirtual || !connection.incomingRoadId.empty();
        if (connection.incomingRoad < 0 && needsIncoming)
            context.mistake(connection.line,
                            "connection " + connection.id + " comes from road " + connection.incomingRoadId +
                                ", which is not there",
                            "correct incomingRoad");
        if (connection.connectingRoad < 0)
            context.mistake(connection.line,
                            "connection " + connection.id + " leads over road " +
                                connection.connectingRoadId + ", which is not there",
                            "correct connectingRoad");
    }
}

void checkControllers(const RoadNetwork& network, ReadContext& context)
{
    std::unordered_set<std::string> signals;
    for (const Road& road : network.roads)
        for (const Signal& signal : road.signals)
            signals.insert(signal.id);
    for (const Controller& controller : network.controllers)
        for (const Controller::Control& control : controller.controls)
            if (!signals.contains(control.signalId))
                context.mistake(controller.line,
                                "controller " + controller.id + " switches signal " + control.signalId +
                                    ", which is not there",
                                "correct signalId");
    for (const Road& road : network.roads)
        for (const SignalReference& reference : road.signalReferences)
            if (!signals.contains(reference.id))
                context.mistake(reference.line,
                                "road " + road.id + ": signal " + reference.id + " is not there",
                                "correct the id of signalReference");
}

template<class Element>
void checkIds(const std::vector<Element>& elements, const char* kind, ReadContext& context)
{
    std::unordered_set<std::string> ids;
    for (const Element& element : elements)
        if (!ids.insert(element.id).second)
            context.mistake(element.line, std::string(kind) + " " + element.id + " is there twice",
                            "give each its own id; links lead to the first");
}

} // namespace

void resolveLinks(RoadNetwork& network, ReadContext& context)
{
    network.index();
    checkIds(network.roads, "road", context);
    checkIds(network.junctions, "junction", context);
    for (Road& road : network.roads)
    {
        context.subject = "road " + road.id;
        resolve(network, context, road.predecessor, "predecessor");
        resolve(network, context, road.successor, "successor");
        checkCircle(road, context, road.predecessor, ContactPoint::start);
        checkCircle(road, context, road.successor, ContactPoint::end);
        if (road.junctionId.empty()) continue;
        road.junction = network.junctionIndex(road.junctionId);
        if (road.junction < 0)
            context.mistake(road.line, "its junction " + road.junctionId + " is not there",
                            "correct the id, or write -1");
    }
    for (Junction& junction : network.junctions)
    {
        context.subject = "junction " + junction.id;
        resolveConnections(network, context, junction);
    }
    context.subject.clear();
    checkControllers(network, context);
}

} // namespace osgRoads::core
