// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <osgRoads/core/check/NetworkCheck.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/read/Problem.h>

namespace osgRoads::core
{

namespace
{

constexpr double kTaperRoundingM = 0.001;
constexpr int kSamplesOfPiece = 8;

/// The least signed width of a lane within its section, at the ends and inside of each piece of its profile.
double leastWidth(const Road& road, const LaneSection& section, const Lane& lane)
{
    double least = 0.0;
    const double length = std::max(std::min(section.end, road.length) - section.s, 0.0);
    const std::vector<Cubic>& pieces = lane.width.pieces();
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
        const double begin = std::min(pieces[i].s, length);
        const double end = i + 1 < pieces.size() ? std::min(pieces[i + 1].s, length) : length;
        for (int k = 0; k <= kSamplesOfPiece; ++k)
        {
            const double ds = begin + (end - begin) * k / kSamplesOfPiece;
            double width = pieces[i].value(ds);
            if (lane.isByBorder)
            {
                const int sign = lane.id > 0 ? 1 : -1;
                const Lane* inside = section.lane(lane.id - sign);
                const bool isInsideByBorder = inside && inside->id != 0 && inside->isByBorder;
                if (!isInsideByBorder && inside && inside->id != 0) continue; // widths inside, border outside
                width = sign * (width - (isInsideByBorder ? inside->width.value(ds) : 0.0));
            }
            least = std::min(least, width);
        }
    }
    return least;
}

bool linksTo(const std::optional<RoadLink>& link, int road)
{
    return link && !link->isJunction && link->index == road;
}

/// Direct junctions join roads that need not name each other.
bool areJoined(const RoadNetwork& network, int a, int b)
{
    for (const Junction& junction : network.junctions)
        for (const JunctionConnection& connection : junction.connections)
            if (std::minmax(connection.incomingRoad, connection.connectingRoad) == std::minmax(a, b))
                return true;
    return false;
}

} // namespace

std::vector<Flaw> checkLaneWidths(const RoadNetwork& network)
{
    std::vector<Flaw> flaws;
    for (const Road& road : network.roads)
        for (const LaneSection& section : road.sections)
            for (const auto* side : {&section.left, &section.right})
                for (const Lane& lane : *side)
                {
                    const double least = leastWidth(road, section, lane);
                    if (least < -kTaperRoundingM)
                        flaws.push_back({FlawKind::negativeWidth, lane.line,
                                         "road " + road.id + ": lane " + std::to_string(lane.id) +
                                             " has a negative width down to " + shortNumber(least) + " m",
                                         "correct its width; 0 is used there", -least});
                }
    return flaws;
}

std::vector<Flaw> checkBackLinks(const RoadNetwork& network)
{
    std::vector<Flaw> flaws;
    for (std::size_t i = 0; i < network.roads.size(); ++i)
    {
        const Road& road = network.roads[i];
        for (const auto* link : {&road.predecessor, &road.successor})
        {
            // The end of a connecting road is answered by its junction.
            if (!*link || (*link)->isJunction || (*link)->index < 0 || !road.junctionId.empty()) continue;
            const Road& other = network.roads[static_cast<std::size_t>((*link)->index)];
            const std::optional<RoadLink>& back =
                (*link)->contactPoint == ContactPoint::start ? other.predecessor : other.successor;
            if (linksTo(back, static_cast<int>(i)) || (*link)->elementS || (back && back->isJunction))
                continue;
            if (areJoined(network, static_cast<int>(i), (*link)->index)) continue;
            flaws.push_back({FlawKind::oneWayLink, (*link)->line,
                             "road " + road.id + " is linked to the " +
                                 ((*link)->contactPoint == ContactPoint::start ? "start" : "end") +
                                 " of road " + other.id + ", which is not linked back",
                             "add road " + road.id + " to the links of road " + other.id, 0.0});
        }
    }
    return flaws;
}

std::size_t NetworkFlaws::count(FlawKind kind) const
{
    return static_cast<std::size_t>(
        std::count_if(flaws.begin(), flaws.end(), [&](const Flaw& flaw) { return flaw.kind == kind; }));
}

NetworkFlaws checkNetwork(const RoadNetwork& network, const JointLimits& limits)
{
    NetworkFlaws found;
    LaneJoints joints = checkLaneJoints(network, limits);
    found.laneJoints = joints.count;
    found.flaws = std::move(joints.flaws);
    for (auto& more : {checkElementJoints(network, limits), checkProfiles(network, limits),
                       checkLaneWidths(network), checkOverlaps(network), checkBackLinks(network)})
        found.flaws.insert(found.flaws.end(), more.begin(), more.end());
    std::stable_sort(found.flaws.begin(), found.flaws.end(),
                     [](const Flaw& a, const Flaw& b) { return a.line < b.line; });
    return found;
}

} // namespace osgRoads::core
