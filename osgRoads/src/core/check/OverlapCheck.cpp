// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <osgRoads/core/check/NetworkCheck.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadLocator.h>
#include <osgRoads/core/query/RoadSurface.h>

namespace osgRoads::core
{

namespace
{

constexpr double kSpacingM = 5.0, kSameHeightM = 1.0;
constexpr double kMostSamples = 1e6; ///< of a network: a longer one is sampled more coarsely

using Pair = std::pair<int, int>;

/// The junctions that a road belongs to or ends at.
std::set<int> junctionsOf(const Road& road)
{
    std::set<int> junctions;
    if (road.junction >= 0) junctions.insert(road.junction);
    for (const auto* link : {&road.predecessor, &road.successor})
        if (*link && (*link)->isJunction && (*link)->index >= 0) junctions.insert((*link)->index);
    return junctions;
}

class OverlapSearch
{
public:
    explicit OverlapSearch(const RoadNetwork& network) : _network(network), _locator(network)
    {
        for (const Road& road : network.roads)
        {
            _junctions.push_back(junctionsOf(road));
            if (road.isUsable) _totalM += road.length;
        }
    }

    std::map<Pair, std::size_t> run()
    {
        const double spacing = std::max(kSpacingM, _totalM / kMostSamples);
        for (int i = 0; i < static_cast<int>(_network.roads.size()); ++i)
        {
            const Road& road = _network.roads[static_cast<std::size_t>(i)];
            if (!road.isUsable) continue;
            for (double s = std::min(0.5 * spacing, 0.5 * road.length); s < road.length; s += spacing)
                lookAt(i, road, s);
        }
        return std::move(_found);
    }

private:
    void lookAt(int index, const Road& road, double s)
    {
        const LaneSection* section = sectionAt(road, s);
        for (const int sign : {1, -1})
            if (section)
                forLanesOutwards(road, *section, sign, s,
                                 [&](const LaneSpan& span)
                                 {
                                     if (isForCars(span.lane->type) && span.width() > 0.5)
                                         lookAtPoint(index, surfacePoint(road, s, span.centreT()));
                                     return true;
                                 });
    }

    void lookAtPoint(int index, const glm::dvec3& point)
    {
        for (const RoadMatch& match : _locator.within(glm::dvec2(point), 0.0))
        {
            const int other = match.position.road;
            if (other == index || areTogether(index, other)) continue;
            const Road& road = _network.roads[static_cast<std::size_t>(other)];
            const double height = surfacePoint(road, match.position.s, match.position.t).z;
            const std::optional<LaneSpan> lane = laneAt(road, match.position.s, match.position.t);
            if (std::fabs(height - point.z) < kSameHeightM && lane && isForCars(lane->lane->type))
                ++_found[std::minmax(index, other)];
        }
    }

    bool areTogether(int a, int b) const
    {
        const auto links = [&](int from, int to)
        {
            const Road& road = _network.roads[static_cast<std::size_t>(from)];
            for (const auto* link : {&road.predecessor, &road.successor})
                if (*link && !(*link)->isJunction && (*link)->index == to) return true;
            return false;
        };
        if (links(a, b) || links(b, a)) return true;
        const std::set<int>& others = _junctions[static_cast<std::size_t>(b)];
        const std::set<int>& own = _junctions[static_cast<std::size_t>(a)];
        return std::any_of(own.begin(), own.end(), [&](int junction) { return others.contains(junction); });
    }

    const RoadNetwork& _network;
    RoadLocator _locator;
    std::vector<std::set<int>> _junctions;
    double _totalM = 0.0;
    std::map<Pair, std::size_t> _found;
};

} // namespace

std::vector<Flaw> checkOverlaps(const RoadNetwork& network)
{
    std::vector<Flaw> flaws;
    for (const auto& [pair, points] : OverlapSearch(network).run())
    {
        const Road& first = network.roads[static_cast<std::size_t>(pair.first)];
        const Road& second = network.roads[static_cast<std::size_t>(pair.second)];
        flaws.push_back({FlawKind::overlap, first.line,
                         "lanes of road " + first.id + " lie over lanes of road " + second.id +
                             ", to which it is not linked",
                         "move one, or join both by a junction", static_cast<double>(points)});
    }
    return flaws;
}

} // namespace osgRoads::core
