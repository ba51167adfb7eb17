// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include <osgRoads/core/check/NetworkCheck.h>
#include <osgRoads/core/read/ReadNetwork.h>

#include "roadtool/Commands.h"
#include "terminal/Terminal.h"

namespace roadtool
{

namespace
{

using namespace osgRoads::core;
using nlohmann::ordered_json;

/// Prints the messages of each kind up to a number, then how many more there are.
class Findings
{
public:
    explicit Findings(std::size_t most) : _most(most) {}

    void add(const std::string& kind, const std::string& message) { _messages[kind].push_back(message); }

    void print() const
    {
        for (const auto& [kind, messages] : _messages)
        {
            const std::size_t shown = _most == 0 ? messages.size() : std::min(_most, messages.size());
            for (std::size_t i = 0; i < shown; ++i)
                std::cout << kind << ": " << messages[i] << '\n';
            if (shown < messages.size())
                std::cout << kind << ": " << messages.size() - shown << " more (--all shows them)\n";
        }
    }

private:
    std::size_t _most;
    std::map<std::string, std::vector<std::string>> _messages;
};

double lengthOf(const RoadNetwork& network)
{
    double length = 0.0;
    for (const Road& road : network.roads)
        if (road.isUsable) length += road.length;
    return length;
}

ordered_json rowOf(const std::string& file, const ReadNetwork& read, const NetworkFlaws& flaws)
{
    std::size_t mistakes = read.mistakesNotListed, unsupported = 0;
    for (const Problem& problem : read.problems)
        (problem.kind == ProblemKind::mistake ? mistakes : unsupported) += problem.count;
    ordered_json row;
    row["file"] = file;
    row["roads"] = read.network.roads.size();
    row["junctions"] = read.network.junctions.size();
    row["lengthM"] = lengthOf(read.network);
    row["laneJoints"] = flaws.laneJoints;
    row["gaps"] = flaws.count(FlawKind::gap);
    row["kinks"] = flaws.count(FlawKind::kink);
    row["steps"] = flaws.count(FlawKind::step);
    row["overlaps"] = flaws.count(FlawKind::overlap);
    row["negativeWidths"] = flaws.count(FlawKind::negativeWidth);
    row["badLinks"] = flaws.count(FlawKind::danglingLane) + flaws.count(FlawKind::oneWayLink);
    row["mistakes"] = mistakes;
    row["unsupported"] = unsupported;
    return row;
}

ordered_json validateFile(const std::string& file, const ReadNetwork& read, std::size_t mostLines)
{
    const NetworkFlaws flaws = checkNetwork(read.network);
    Findings findings(mostLines);
    for (const Problem& problem : read.problems)
        findings.add(problem.kind == ProblemKind::mistake ? "mistake" : "unsupported", problem.message(file));
    for (const Flaw& flaw : flaws.flaws)
        findings.add(wordOf(flaw.kind), flaw.message(file));
    findings.print();
    ordered_json row = rowOf(file, read, flaws);
    std::cout << "usable " << file << ':';
    for (const auto& [key, value] : row.items())
        if (key != "file") std::cout << ' ' << key << ' ' << value.dump();
    std::cout << '\n';
    return row;
}

} // namespace

foundation::Result<Report> validate(const Request& request)
{
    Report report;
    for (const std::string& file : request.files)
    {
        const auto read = readNetwork(file);
        if (read)
        {
            report.json["files"].push_back(validateFile(file, *read, request.mostLines));
            continue;
        }
        report.sound = false;
        terminal::fail("roadtool", read.error());
        report.json["files"].push_back({{"file", file}, {"error", read.error().message()}});
    }
    return report;
}

} // namespace roadtool
