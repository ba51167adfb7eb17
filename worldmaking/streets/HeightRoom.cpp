// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/HeightRoom.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>

namespace worldmaking
{

HeightRoom::HeightRoom(std::vector<double> heightsM, const std::vector<scenery::HeightStep>& steps)
    : _heightsM(std::move(heightsM)), _edges(_heightsM.size())
{
    for (const scenery::HeightStep& step : steps)
    {
        const double rise = _heightsM[step.to] - _heightsM[step.from];
        _edges[step.from].push_back({step.to, std::max(0.0, step.mostM - rise)});
        _edges[step.to].push_back({step.from, std::max(0.0, rise - step.leastM)});
    }
}

double HeightRoom::mostM(std::size_t lower, std::size_t upper, double riseM) const
{
    const double neededM = riseM - (_heightsM[upper] - _heightsM[lower]);
    using Reached = std::pair<double, std::size_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
    std::unordered_map<std::size_t, double> least = {{lower, 0.0}};
    queue.emplace(0.0, lower);
    while (!queue.empty())
    {
        const auto [roomM, node] = queue.top();
        queue.pop();
        if (roomM >= neededM) return riseM; // whatever comes has more
        if (node == upper) return _heightsM[upper] - _heightsM[lower] + roomM;
        if (roomM > least[node]) continue;
        for (const Edge& edge : _edges[node])
        {
            const auto [found, isNew] = least.try_emplace(edge.to, roomM + edge.slackM);
            if (!isNew && found->second <= roomM + edge.slackM) continue;
            found->second = roomM + edge.slackM;
            queue.emplace(found->second, edge.to);
        }
    }
    return riseM;
}

} // namespace worldmaking
