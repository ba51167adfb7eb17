// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/earth/WaterLevels.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>

namespace worldmaking
{

namespace
{

/// Each node gets the first value, in the order given, of those from which it is reached.
std::vector<double> spread(const WaterNet& net, const std::vector<std::uint32_t>& order, bool downstream)
{
    const std::size_t count = net.groundM.size();
    std::vector<std::vector<std::uint32_t>> next(count);
    for (const auto& [from, to] : net.flows)
        next[downstream ? from : to].push_back(downstream ? to : from);
    std::vector<double> levels(count);
    std::vector<char> isDone(count, 0);
    std::vector<std::uint32_t> waiting;
    for (const std::uint32_t first : order)
    {
        waiting.push_back(first);
        while (!waiting.empty())
        {
            const std::uint32_t node = waiting.back();
            waiting.pop_back();
            if (isDone[node]) continue;
            isDone[node] = 1;
            levels[node] = net.groundM[first];
            waiting.insert(waiting.end(), next[node].begin(), next[node].end());
        }
    }
    return levels;
}

} // namespace

std::vector<double> waterLevels(const WaterNet& net)
{
    std::vector<std::uint32_t> order(net.groundM.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return net.groundM[a] < net.groundM[b]; });
    const std::vector<double> cut = spread(net, order, true); // the lowest ground upstream
    std::reverse(order.begin(), order.end());
    const std::vector<double> filled = spread(net, order, false); // the highest ground downstream
    std::vector<double> levels;
    for (std::size_t i = 0; i < cut.size(); ++i)
        levels.push_back(std::lerp(filled[i], cut[i], kCutShare));
    return levels;
}

std::vector<double> spreadFalls(const WaterNet& net, const std::vector<double>& levels)
{
    /// A node may lie no higher than another, and `aboveM`.
    struct Bound
    {
        std::uint32_t node;
        double aboveM;
    };
    std::vector<std::vector<Bound>> bounds(levels.size());
    for (std::size_t flow = 0; flow < net.flows.size(); ++flow)
    {
        const auto [from, to] = net.flows[flow];
        bounds[to].push_back({from, kRiverGrade * net.flowsM[flow]});
        bounds[from].push_back({to, 0.0});
    }
    std::vector<double> gentle = levels;
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
    for (std::uint32_t node = 0; node < levels.size(); ++node)
        waiting.emplace(levels[node], node);
    while (!waiting.empty())
    {
        const auto [level, node] = waiting.top();
        waiting.pop();
        if (level > gentle[node]) continue; // it has come to lie lower since
        for (const Bound& bound : bounds[node])
        {
            const double most = level + bound.aboveM;
            if (most >= gentle[bound.node]) continue;
            gentle[bound.node] = most;
            waiting.emplace(most, bound.node);
        }
    }
    for (std::size_t i = 0; i < levels.size(); ++i)
        gentle[i] = std::max(gentle[i], levels[i] - kMostSpreadM);
    return gentle;
}

} // namespace worldmaking
