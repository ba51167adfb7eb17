// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iostream>
#include <map>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/read/ReadNetwork.h>

#include "roadtool/Commands.h"
#include "roadtool/TopView.h"
#include "scenery/roads/things/CountThings.h"

namespace roadtool
{

namespace
{

using namespace osgRoads::core;
using nlohmann::ordered_json;

struct Contents
{
    double lengthM = 0.0, carLaneLengthM = 0.0;
    std::size_t usable = 0, sections = 0, lanes = 0, signals = 0, objects = 0, bridges = 0, tunnels = 0;
    std::map<std::string, std::size_t> geometry;
};

void addRoad(const Road& road, Contents& contents)
{
    contents.signals += road.signals.size();
    contents.objects += road.objects.size();
    for (const RoadStructure& structure : road.structures)
        ++(structure.kind == StructureKind::bridge ? contents.bridges : contents.tunnels);
    contents.sections += road.sections.size();
    for (const LaneSection& section : road.sections)
        contents.lanes += section.left.size() + section.right.size();
    if (!road.isUsable) return;
    ++contents.usable;
    contents.lengthM += road.length;
    for (const LaneSection& section : road.sections)
        for (const auto* side : {&section.left, &section.right})
            for (const Lane& lane : *side)
                if (isForCars(lane.type)) contents.carLaneLengthM += std::max(section.end - section.s, 0.0);
    for (const PlanElement& element : road.referenceLine.elements())
        ++contents.geometry[element.word()];
}

std::size_t mistakesIn(const ReadNetwork& read)
{
    return read.mistakesNotListed +
           static_cast<std::size_t>(std::count_if(read.problems.begin(), read.problems.end(),
                                                  [](const Problem& problem)
                                                  { return problem.kind == ProblemKind::mistake; }));
}

ordered_json describe(const std::string& file, const ReadNetwork& read)
{
    const RoadNetwork& network = read.network;
    Contents contents;
    for (const Road& road : network.roads)
        addRoad(road, contents);
    ordered_json row;
    row["file"] = file;
    row["version"] = std::to_string(network.header.revMajor) + "." + std::to_string(network.header.revMinor);
    row["geoReference"] = network.header.geoReference;
    row["roads"] = network.roads.size();
    row["roadsLeftOut"] = network.roads.size() - contents.usable;
    row["junctions"] = network.junctions.size();
    row["controllers"] = network.controllers.size();
    row["lengthM"] = contents.lengthM;
    row["carLaneLengthM"] = contents.carLaneLengthM;
    row["laneSections"] = contents.sections;
    row["lanes"] = contents.lanes;
    row["geometry"] = contents.geometry;
    row["signals"] = contents.signals;
    row["objects"] = contents.objects;
    row["bridges"] = contents.bridges;
    row["tunnels"] = contents.tunnels;
    const PlanBox bounds = boundsOf(network);
    row["westM"] = bounds.least.x;
    row["southM"] = bounds.least.y;
    row["eastM"] = bounds.most.x;
    row["northM"] = bounds.most.y;
    row["mistakes"] = mistakesIn(read);
    const scenery::roads::ThingCounts things = scenery::roads::countThings(network);
    row["models"] = things.models;
    row["painted"] = things.painted;
    row["withoutModel"] = things.withoutModel;
    row["unsupported"] = ordered_json::array();
    for (const Problem& problem : read.problems)
        if (problem.kind == ProblemKind::unsupported)
            row["unsupported"].push_back(
                {{"what", problem.what}, {"line", problem.line}, {"count", problem.count}});
    return row;
}

void print(const ordered_json& row)
{
    std::cout << row["file"].get<std::string>() << '\n';
    for (const auto& [key, value] : row.items())
    {
        if (key == "file" || key == "unsupported") continue;
        std::cout << "  " << key << ": " << (value.is_string() ? value.get<std::string>() : value.dump())
                  << '\n';
    }
    for (const ordered_json& entry : row["unsupported"])
        std::cout << "  line " << entry["line"] << ": " << entry["what"].get<std::string>() << ", "
                  << entry["count"] << " times\n";
}

} // namespace

foundation::Result<Report> info(const Request& request)
{
    Report report;
    for (const std::string& file : request.files)
    {
        const auto read = readNetwork(file);
        if (!read) return read.error();
        report.json["files"].push_back(describe(file, *read));
        print(report.json["files"].back());
    }
    return report;
}

} // namespace roadtool
