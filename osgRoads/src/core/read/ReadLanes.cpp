// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 11 (lanes).
#include <algorithm>
#include <cstdlib>
#include <utility>

#include "ElementReaders.h"

namespace osgRoads::core
{

namespace
{

std::vector<LaneRule> readRules(NodeReader& lane, const char* name)
{
    std::vector<LaneRule> rules;
    const auto read = [&](NodeReader& entry)
    {
        LaneRule rule;
        rule.s = entry.number("sOffset");
        if (std::string_view(name) == "access")
        {
            rule.rule = entry.text("rule");
            rule.restriction = entry.text("restriction");
            entry.each("restriction", [&](NodeReader& child) // since 1.8
                       { rule.restriction += (rule.restriction.empty() ? "" : " ") + child.id("type"); });
        }
        else if (std::string_view(name) == "rule")
            rule.restriction = entry.text("value");
        else
        {
            rule.restriction = entry.text("surface");
            rule.friction = entry.numberOr("friction", 0.0);
            rule.roughness = entry.numberOr("roughness", 0.0);
        }
        rules.push_back(std::move(rule));
    };
    lane.each(name, read);
    sortByStart(lane, name, rules);
    return rules;
}

void readLaneLinks(NodeReader& element, Lane& lane)
{
    element.each("link",
                 [&](NodeReader& link)
                 {
                     link.each("predecessor",
                               [&](NodeReader& end) { lane.predecessors.push_back(end.integer("id", 0)); });
                     link.each("successor",
                               [&](NodeReader& end) { lane.successors.push_back(end.integer("id", 0)); });
                 });
    // 0 is the centre lane: programs write it for "none".
    std::erase(lane.predecessors, 0);
    std::erase(lane.successors, 0);
}

/// `sectionS`: where its section begins.
void readLaneWidth(NodeReader& element, double sectionS, Lane& lane)
{
    lane.width = element.profile("width", "sOffset");
    const CubicProfile border = element.profile("border", "sOffset");
    if (!border.isEmpty() && lane.width.isEmpty())
    {
        lane.width = border;
        lane.isByBorder = true;
    }
    else if (!border.isEmpty())
        element.mistake("lane " + std::to_string(lane.id) + " has width and border",
                        "keep one of them; the width is used");
    if (lane.id != 0 && lane.width.isEmpty())
        element.mistake("lane " + std::to_string(lane.id) + " of the section at s " + shortNumber(sectionS) +
                            " has neither width nor border",
                        "add a width; 0 is used");
    else if (lane.id != 0 && lane.width.pieces().front().s > 1e-6)
        element.mistake("the width of lane " + std::to_string(lane.id) + " begins at sOffset " +
                            shortNumber(lane.width.pieces().front().s),
                        "begin it at 0; the width before is 0");
}

Lane readLane(NodeReader& element, double sectionS)
{
    Lane lane;
    lane.line = element.line();
    lane.id = element.integer("id", 0);
    lane.type = element.choice("type", kLaneTypes, LaneType::none);
    lane.isLevel = element.flag("level");
    lane.direction = element.choice("direction", kLaneDirections, LaneDirection::standard);
    readLaneLinks(element, lane);
    readLaneWidth(element, sectionS, lane);
    lane.marks = readRoadMarks(element);
    element.each("height",
                 [&](NodeReader& entry)
                 {
                     lane.heights.push_back({entry.number("sOffset"), entry.numberOr("inner", 0.0),
                                             entry.numberOr("outer", 0.0)});
                 });
    sortByStart(element, "height", lane.heights);
    element.each("speed",
                 [&](NodeReader& entry) {
                     lane.speeds.push_back({entry.number("sOffset"), readSpeed(entry)});
                 });
    sortByStart(element, "speed", lane.speeds);
    lane.access = readRules(element, "access");
    lane.rules = readRules(element, "rule");
    lane.materials = readRules(element, "material");
    return lane;
}

/// Puts the lanes of a side in order from the centre; drops those of the wrong side, of an id that is there
/// already, or behind a missing one.
void arrange(NodeReader& section, std::vector<Lane>& lanes, int sign)
{
    std::erase_if(lanes,
                  [&](const Lane& lane)
                  {
                      const bool isWrong = lane.id * static_cast<long>(sign) <= 0;
                      if (isWrong)
                          section.context.mistake(
                              lane.line, "lane " + std::to_string(lane.id) + " stands on the wrong side",
                              "left lanes are positive, right lanes negative");
                      return isWrong;
                  });
    std::stable_sort(lanes.begin(), lanes.end(),
                     [](const Lane& a, const Lane& b)
                     { return std::abs(static_cast<long>(a.id)) < std::abs(static_cast<long>(b.id)); });
    for (std::size_t i = 0; i < lanes.size();)
    {
        const long expected = sign * static_cast<long>(i + 1);
        if (lanes[i].id == expected)
        {
            ++i;
            continue;
        }
        const bool isDouble = i > 0 && lanes[i].id == lanes[i - 1].id;
        section.context.mistake(
            lanes[i].line,
            "lane " + std::to_string(lanes[i].id) + (isDouble ? " is there twice" : " has no lane inside it"),
            isDouble ? "remove one; the first is used" : "number the lanes without gaps; it is left out");
        lanes.erase(lanes.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

LaneSection readSection(NodeReader& element)
{
    LaneSection section;
    section.line = element.line();
    section.s = element.number("s");
    section.isSingleSide = element.flag("singleSide");
    element.each(
        "left", [&](NodeReader& side)
        { side.each("lane", [&](NodeReader& lane) { section.left.push_back(readLane(lane, section.s)); }); });
    element.each("right",
                 [&](NodeReader& side) {
                     side.each("lane",
                               [&](NodeReader& lane) { section.right.push_back(readLane(lane, section.s)); });
                 });
    bool hasCentre = false;
    element.each("center",
                 [&](NodeReader& side)
                 {
                     side.each("lane",
                               [&](NodeReader& lane)
                               {
                                   section.centre = readLane(lane, section.s);
                                   hasCentre = true;
                               });
                 });
    if (!hasCentre) element.mistake("the lane section has no centre lane", "add lane 0");
    section.centre.id = 0;
    arrange(element, section.left, 1);
    arrange(element, section.right, -1);
    return section;
}

} // namespace

std::optional<double> readSpeed(NodeReader& element)
{
    const std::string most = element.text("max"), unit = element.text("unit");
    if (most.empty() || most == "no limit" || most == "undefined") return std::nullopt;
    const double value = element.number("max");
    if (value < 0.0) return std::nullopt; // -1: older versions for no limit
    if (unit.empty() || unit == "m/s") return value;
    if (unit == "km/h") return value / 3.6;
    if (unit == "mph") return value * 0.44704;
    element.mistake("speed/unit has the unknown value \"" + unit.substr(0, 40) + "\"",
                    "write m/s, km/h or mph; m/s is used");
    return value;
}

void readLanes(NodeReader& road, Road& into)
{
    road.each("lanes",
              [&](NodeReader& lanes)
              {
                  into.laneOffset = lanes.profile("laneOffset", "s");
                  lanes.each("laneSection",
                             [&](NodeReader& section) { into.sections.push_back(readSection(section)); });
                  sortByStart(lanes, "laneSection", into.sections);
              });
    if (into.sections.empty())
    {
        road.mistake("there is no lane section", "add one; the road has no surface");
        return;
    }
    into.sections.front().s = 0.0;
    for (std::size_t i = 0; i < into.sections.size(); ++i)
        into.sections[i].end = i + 1 < into.sections.size() ? into.sections[i + 1].s : into.length;
    for (const LaneSection& section : into.sections)
        if ((section.s > into.length && into.length > 0.0) || section.s < 0.0)
            road.context.mistake(section.line,
                                 "a lane section begins at s " + shortNumber(section.s) + ", beyond the road",
                                 "let it begin on the road");
}

} // namespace osgRoads::core
