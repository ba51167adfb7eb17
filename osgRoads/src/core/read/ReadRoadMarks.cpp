// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 11.9 (road markings).
#include <utility>

#include "ElementReaders.h"

namespace osgRoads::core
{

namespace
{

MarkLine readLine(NodeReader& element, MarkColour colour, bool isRepeated)
{
    MarkLine line;
    line.length = element.number("length");
    if (isRepeated) line.space = element.number("space");
    line.tOffset = element.number("tOffset");
    line.sOffset = element.number("sOffset");
    line.width = element.numberOr("width", 0.0);
    line.colour = element.choice("color", kMarkColours, colour);
    line.rule = element.text("rule");
    if (line.length < 0.0 || line.space < 0.0 || line.width < 0.0)
    {
        element.mistake("a line of a road mark has a negative length, space or width",
                        "write 0 or more; 0 is used");
        line.length = std::max(line.length, 0.0);
        line.space = std::max(line.space, 0.0);
        line.width = std::max(line.width, 0.0);
    }
    return line;
}

RoadMark readMark(NodeReader& element)
{
    RoadMark mark;
    mark.s = element.number("sOffset");
    mark.type = element.choice("type", kMarkTypes, MarkType::none);
    mark.weight = element.choice("weight", kMarkWeights, MarkWeight::standard);
    mark.colour = element.choice("color", kMarkColours, MarkColour::standard);
    mark.width = element.numberOr("width", 0.0);
    if (mark.width < 0.0)
    {
        element.mistake("roadMark/width is negative", "write 0 or more; the usual width is used");
        mark.width = 0.0;
    }
    mark.height = element.numberOr("height", 0.0);
    mark.laneChange = element.choice("laneChange", kLaneChanges, LaneChange::both);
    mark.material = element.text("material");
    element.each("type",
                 [&](NodeReader& type)
                 {
                     type.has("name");
                     const double width = type.numberOr("width", 0.0);
                     type.each("line",
                               [&](NodeReader& line)
                               {
                                   mark.lines.push_back(readLine(line, mark.colour, true));
                                   if (mark.lines.back().width == 0.0) mark.lines.back().width = width;
                               });
                 });
    element.each("explicit",
                 [&](NodeReader& pieces)
                 {
                     pieces.each("line", [&](NodeReader& line)
                                 { mark.explicitLines.push_back(readLine(line, mark.colour, false)); });
                 });
    mark.sway = element.profile("sway", "ds");
    return mark;
}

} // namespace

std::vector<RoadMark> readRoadMarks(NodeReader& lane)
{
    std::vector<RoadMark> marks;
    lane.each("roadMark", [&](NodeReader& element) { marks.push_back(readMark(element)); });
    sortByStart(lane, "roadMark", marks);
    return marks;
}

} // namespace osgRoads::core
