// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <sstream>
#include <string>

#include <foundation/WholeFile.h>

#include <osgRoads/core/write/WriteNetwork.h>

#include "ElementWriters.h"
#include "XmlFields.h"

namespace osgRoads::core
{

namespace
{

bool hasUnwrittenLane(const std::vector<Lane>& lanes)
{
    const auto isUnwritten = [](const Lane& lane)
    {
        return !lane.rules.empty() || !lane.materials.empty() ||
               std::any_of(lane.marks.begin(), lane.marks.end(),
                           [](const RoadMark& mark) {
                               return !mark.lines.empty() || !mark.explicitLines.empty() ||
                                      !mark.sway.isEmpty();
                           });
    };
    return std::any_of(lanes.begin(), lanes.end(), isUnwritten);
}

/// Names what a road has that would be lost; empty: nothing.
std::string unwritten(const Road& road)
{
    if (!road.crossfall.leftRad.isEmpty() || !road.crossfall.rightRad.isEmpty()) return "a crossfall";
    if (!road.shapes.empty()) return "a shape";
    const auto isUnwritten = [](const RoadObject& object)
    {
        return !object.outlines.empty() || !object.repeats.empty() || !object.markings.empty() ||
               !object.validities.empty() || object.radius > 0.0 || object.pitchRad != 0.0 ||
               object.rollRad != 0.0 || object.isDynamic || object.validLength != 0.0 ||
               !object.parkingAccess.empty() || object.isPerpendicularToRoad;
    };
    if (std::any_of(road.objects.begin(), road.objects.end(), isUnwritten))
        return "an object with outlines, repeats, marks or lanes of its own";
    const auto isUnwrittenSignal = [](const Signal& signal)
    { return signal.post || !signal.dependencies.empty() || !signal.references.empty(); };
    if (std::any_of(road.signals.begin(), road.signals.end(), isUnwrittenSignal))
        return "a signal with a post elsewhere, dependencies or references";
    if (!road.signalReferences.empty()) return "a reference to a signal";
    for (const LaneSection& section : road.sections)
        if (hasUnwrittenLane(section.left) || hasUnwrittenLane(section.right) ||
            hasUnwrittenLane({section.centre}))
            return "a lane with rules or explicit marks";
    return {};
}

void writeHeader(pugi::xml_node root, const NetworkHeader& header)
{
    pugi::xml_node node = root.append_child("header");
    set(node, "revMajor", 1);
    set(node, "revMinor", 7);
    set(node, "name", header.name);
    if (!header.date.empty()) set(node, "date", header.date);
    set(node, "vendor", header.vendor);
    if (!header.geoReference.empty())
        node.append_child("geoReference")
            .append_child(pugi::node_cdata)
            .set_value(header.geoReference.c_str());
    if (header.offsetX == 0.0 && header.offsetY == 0.0 && header.offsetZ == 0.0 &&
        header.offsetHeadingRad == 0.0)
        return;
    const pugi::xml_node offset = node.append_child("offset");
    set(offset, "x", header.offsetX);
    set(offset, "y", header.offsetY);
    set(offset, "z", header.offsetZ);
    set(offset, "hdg", header.offsetHeadingRad);
}

} // namespace

foundation::Outcome writeNetwork(const RoadNetwork& network, const std::filesystem::path& file)
{
    for (const Road& road : network.roads)
        if (const std::string lost = unwritten(road); !lost.empty())
            return foundation::Error{file.string(),
                                     "road " + road.id + " has " + lost + ", which is not written",
                                     "take it out of the network first"};
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    set(declaration, "version", "1.0");
    set(declaration, "encoding", "UTF-8");
    pugi::xml_node root = document.append_child("OpenDRIVE");
    writeHeader(root, network.header);
    for (const Road& road : network.roads)
        writeRoad(root, road);
    for (const Controller& controller : network.controllers)
        writeController(root, controller);
    for (const Junction& junction : network.junctions)
        writeJunction(root, junction);
    std::ostringstream text;
    document.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
    return foundation::writeWholeFile(file, text.str());
}

} // namespace osgRoads::core
