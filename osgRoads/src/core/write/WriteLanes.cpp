// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.7, 11 (lanes).
#include "ElementWriters.h"
#include "XmlFields.h"

namespace osgRoads::core
{

namespace
{

void writeMark(pugi::xml_node lane, const RoadMark& mark)
{
    const pugi::xml_node node = lane.append_child("roadMark");
    set(node, "sOffset", mark.s);
    set(node, "type", keyword(kMarkTypes, mark.type));
    set(node, "weight", keyword(kMarkWeights, mark.weight));
    set(node, "color", keyword(kMarkColours, mark.colour));
    if (!mark.material.empty()) set(node, "material", mark.material);
    if (mark.width > 0.0) set(node, "width", mark.width);
    set(node, "laneChange", keyword(kLaneChanges, mark.laneChange));
    if (mark.height > 0.0) set(node, "height", mark.height);
}

void writeLinks(pugi::xml_node node, const Lane& lane)
{
    if (lane.predecessors.empty() && lane.successors.empty()) return;
    pugi::xml_node link = node.append_child("link");
    for (const int id : lane.predecessors)
        set(link.append_child("predecessor"), "id", id);
    for (const int id : lane.successors)
        set(link.append_child("successor"), "id", id);
}

void writeSpeeds(pugi::xml_node node, const Lane& lane)
{
    for (const SpeedLimit& speed : lane.speeds)
    {
        const pugi::xml_node entry = node.append_child("speed");
        set(entry, "sOffset", speed.s);
        if (speed.metresPerSecond)
            set(entry, "max", *speed.metresPerSecond), set(entry, "unit", "m/s");
        else
            set(entry, "max", "no limit");
    }
}

void writeLane(pugi::xml_node side, const Lane& lane)
{
    pugi::xml_node node = side.append_child("lane");
    set(node, "id", lane.id);
    set(node, "type", lane.id == 0 ? std::string_view("none") : wordOf(lane.type));
    set(node, "level", lane.isLevel ? "true" : "false");
    if (lane.direction != LaneDirection::standard)
        set(node, "direction", keyword(kLaneDirections, lane.direction));
    writeLinks(node, lane);
    if (lane.id != 0) writeProfile(node, lane.isByBorder ? "border" : "width", "sOffset", lane.width);
    for (const RoadMark& mark : lane.marks)
        writeMark(node, mark);
    writeSpeeds(node, lane);
    for (const LaneRule& access : lane.access)
    {
        const pugi::xml_node entry = node.append_child("access");
        set(entry, "sOffset", access.s);
        if (!access.rule.empty()) set(entry, "rule", access.rule);
        set(entry, "restriction", access.restriction);
    }
    for (const LaneHeight& height : lane.heights)
    {
        const pugi::xml_node entry = node.append_child("height");
        set(entry, "sOffset", height.s);
        set(entry, "inner", height.inner);
        set(entry, "outer", height.outer);
    }
}

void writeSection(pugi::xml_node lanes, const LaneSection& section)
{
    pugi::xml_node node = lanes.append_child("laneSection");
    set(node, "s", section.s);
    if (section.isSingleSide) set(node, "singleSide", "true");
    if (!section.left.empty())
    {
        const pugi::xml_node left = node.append_child("left"); // outermost first
        for (auto lane = section.left.rbegin(); lane != section.left.rend(); ++lane)
            writeLane(left, *lane);
    }
    writeLane(node.append_child("center"), section.centre);
    if (section.right.empty()) return;
    const pugi::xml_node right = node.append_child("right");
    for (const Lane& lane : section.right)
        writeLane(right, lane);
}

} // namespace

void writeLanes(pugi::xml_node roadNode, const Road& road)
{
    pugi::xml_node lanes = roadNode.append_child("lanes");
    writeProfile(lanes, "laneOffset", "s", road.laneOffset);
    for (const LaneSection& section : road.sections)
        writeSection(lanes, section);
}

} // namespace osgRoads::core
