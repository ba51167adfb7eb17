// SPDX-License-Identifier: Apache-2.0
// Source: Dijkstra, *A note on two problems in connexion with graphs*, 1959, over ends of roads.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <set>
#include <tuple>

#include "simulation/road/RoadWalk.h"
#include "simulation/road/SpeedLimit.h"

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
    WaySearch(const RoadScene& roads, const RoadPlace& from, const RoadPlace& to,
              RouteStrategy strategy = RouteStrategy::shortest)
        : _roads(roads), _network(roads.network()), _from(from), _to(to), _strategy(strategy)
    {
    }

    /// The way that leaves the road of the start at one of its ends.
    std::optional<FoundWay> run(bool towardsEnd, double mostM)
    {
        const double first = towardsEnd ? lengthOf(_from.road) - _from.s : _from.s;
        push({_from.road, towardsEnd}, costOf(_from.road, first), {});
        while (!_queue.empty())
        {
            const auto [metres, end, before] = _queue.top();
            _queue.pop();
            if (metres > mostM) break;
            if (!_before.emplace(end, before).second) continue;
            for (const RoadStep& step : stepsFrom(_network, end.road, end.atEnd, 0))
            {
                if (step.road == _to.road)
                {
                    const double last = step.entersAtStart ? _to.s : lengthOf(_to.road) - _to.s;
                    return FoundWay{metres + costOf(_to.road, last), roadsTo(end)};
                }
                push({step.road, step.entersAtStart}, metres + costOf(step.road, lengthOf(step.road)), end);
            }
        }
        return std::nullopt;
    }

private:
    using Open = std::tuple<double, RoadEnd, RoadEnd>; ///< metres so far, the end reached, the one before

    double lengthOf(int road) const { return _network.roads[static_cast<std::size_t>(road)].length; }

    /// Metres; for the fastest way seconds times the usual speed, for the one of least intersections with 10
    /// km for each.
    double costOf(int road, double metres) const
    {
        constexpr double kDefaultRoadMps = 50.0 / 3.6, kIntersectionM = 1e4;
        if (_strategy == RouteStrategy::fastest)
        {
            RoadPlace place;
            place.road = road;
            return metres * kDefaultRoadMps /
                   std::max(speedLimitAt(_roads, place).value_or(kDefaultRoadMps), 0.1);
        }
        const bool isInJunction = !_network.roads[static_cast<std::size_t>(road)].junctionId.empty();
        return _strategy == RouteStrategy::leastIntersections && isInJunction ? metres + kIntersectionM
                                                                              : metres;
    }

    void push(RoadEnd end, double metres, RoadEnd before) { _queue.push({metres, end, before}); }

    RoadWay roadsTo(RoadEnd end) const
    {
        RoadWay way{_to.road};
        for (; end.road >= 0; end = _before.at(end))
            way.push_back(end.road);
        std::reverse(way.begin(), way.end());
        return way;
    }

    const RoadScene& _roads;
    const osgRoads::core::RoadNetwork& _network;
    const RoadPlace& _from;
    const RoadPlace& _to;
    RouteStrategy _strategy;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> _queue;
    std::map<RoadEnd, RoadEnd> _before;
};

/// Draws a way without a road twice: at each end of a road the roads that follow are tried in a random order,
/// the last one that leads nowhere is given up.
std::optional<RoadWay> drawnWay(const RoadScene& roads, const RoadPlace& from, const RoadPlace& to,
                                RandomDraw& draw)
{
    struct Open
    {
        int road;
        std::vector<RoadStep> steps; ///< not tried yet
    };
    const auto stepsOf = [&](int road, bool atEnd)
    {
        std::vector<RoadStep> steps = stepsFrom(roads.network(), road, atEnd, 0);
        for (std::size_t i = steps.size(); i > 1; --i)
            std::swap(steps[i - 1], steps[draw.index(std::vector<double>(i, 1.0))]);
        return steps;
    };
    std::set<int> visited{from.road};
    std::vector<Open> open{{from.road, stepsOf(from.road, looksForward(from))}};
    while (!open.empty())
    {
        if (open.back().steps.empty())
        {
            open.pop_back();
            continue;
        }
        const RoadStep step = open.back().steps.back();
        open.back().steps.pop_back();
        if (step.road == to.road)
        {
            RoadWay way;
            for (const Open& passed : open)
                way.push_back(passed.road);
            way.push_back(to.road);
            return way;
        }
        if (visited.insert(step.road).second)
            open.push_back({step.road, stepsOf(step.road, step.entersAtStart)});
    }
    return std::nullopt;
}

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

std::optional<RoadWay> wayBetween(const RoadScene& roads, const RoadPlace& from, const RoadPlace& to,
                                  RouteStrategy strategy, RandomDraw* draw)
{
    constexpr double kFarthestM = 1e9;
    const bool forward = looksForward(from);
    if (from.road == to.road && (forward ? to.s >= from.s : to.s <= from.s)) return RoadWay{from.road};
    if (strategy == RouteStrategy::random && draw) return drawnWay(roads, from, to, *draw);
    if (auto found = WaySearch(roads, from, to, strategy).run(forward, kFarthestM))
        return std::move(found->roads);
    return std::nullopt;
}

} // namespace simulation
