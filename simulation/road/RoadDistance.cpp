// SPDX-License-Identifier: Apache-2.0
// Source: Dijkstra, *A note on two problems in connexion with graphs*, 1959, over ends of roads.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <tuple>

#include "simulation/road/RoadWalk.h"

namespace simulation
{
namespace
{

struct RoadEnd
{
    int road = -1;
    bool atEnd = true;

    auto operator<=>(const RoadEnd&) const = default;
};

struct FoundWay
{
    double lengthM = 0.0;
    RoadWay roads;
};

class WaySearch
{
public:
    WaySearch(const RoadScene& roads, const RoadPlace& from, const RoadPlace& to)
        : _network(roads.network()), _from(from), _to(to)
    {
    }

    /// The way that leaves the road of the start at one of its ends.
    std::optional<FoundWay> run(bool towardsEnd, double mostM)
    {
        push({_from.road, towardsEnd}, towardsEnd ? lengthOf(_from.road) - _from.s : _from.s, {});
        while (!_queue.empty())
        {
            const auto [metres, end, before] = _queue.top();
            _queue.pop();
            if (metres > mostM) break;
            if (!_before.emplace(end, before).second) continue;
            for (const RoadStep& step : stepsFrom(_network, end.road, end.atEnd, 0))
            {
                if (step.road == _to.road)
                    return FoundWay{metres + (step.entersAtStart ? _to.s : lengthOf(_to.road) - _to.s),
                                    roadsTo(end)};
                push({step.road, step.entersAtStart}, metres + lengthOf(step.road), end);
            }
        }
        return std::nullopt;
    }

private:
    using Open = std::tuple<double, RoadEnd, RoadEnd>; ///< metres so far, the end reached, the one before

    double lengthOf(int road) const { return _network.roads[static_cast<std::size_t>(road)].length; }
    void push(RoadEnd end, double metres, RoadEnd before) { _queue.push({metres, end, before}); }

    RoadWay roadsTo(RoadEnd end) const
    {
        RoadWay way{_to.road};
        for (; end.road >= 0; end = _before.at(end))
            way.push_back(end.road);
        std::reverse(way.begin(), way.end());
        return way;
    }

    const osgRoads::core::RoadNetwork& _network;
    const RoadPlace& _from;
    const RoadPlace& _to;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> _queue;
    std::map<RoadEnd, RoadEnd> _before;
};

} // namespace

std::optional<double> distanceAlong(const RoadScene& roads, const RoadPlace& from, const RoadPlace& to,
                                    double mostM)
{
    const bool forward = looksForward(from);
    if (from.road == to.road) return forward ? to.s - from.s : from.s - to.s;
    const auto ahead = WaySearch(roads, from, to).run(forward, mostM);
    const auto behind = WaySearch(roads, from, to).run(!forward, mostM);
    if (ahead && (!behind || ahead->lengthM <= behind->lengthM)) return ahead->lengthM;
    if (behind) return -behind->lengthM;
    return std::nullopt;
}

std::optional<RoadWay> wayBetween(const RoadScene& roads, const RoadPlace& from, const RoadPlace& to)
{
    constexpr double kFarthestM = 1e6;
    const bool forward = looksForward(from);
    if (from.road == to.road && (forward ? to.s >= from.s : to.s <= from.s)) return RoadWay{from.road};
    if (auto found = WaySearch(roads, from, to).run(forward, kFarthestM)) return std::move(found->roads);
    return std::nullopt;
}

} // namespace simulation
