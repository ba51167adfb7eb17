// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/RoadPlan.h"

#include <algorithm>
#include <set>
#include <utility>

#include "worldmaking/madeup/SmoothPath.h"

namespace worldmaking
{

namespace
{

constexpr double kMeetM =
    75.0; ///< from a road that is left at a right angle to where the new one turns its own way
constexpr double kShortestRoadM = 90.0; ///< shorter roads are not built
constexpr double kFootReachM = 400.0;   ///< the smoothed road is within it of the way that was searched

std::string_view roadKindOf(const Settlement& a, const Settlement& b)
{
    const auto lesser = std::max(a.kind, b.kind), greater = std::min(a.kind, b.kind);
    if (lesser == SettlementKind::hamlet)
        return greater == SettlementKind::town ? "tertiary" : "unclassified";
    return greater == SettlementKind::town ? "secondary" : "tertiary";
}

/// Lets an end of a path meet the web at a right angle, where it is near: what lies within kMeetM of the web
/// gives way to a straight line to its nearest point.
void meetWeb(std::vector<glm::dvec2>& path, const WayWeb& web)
{
    if (path.size() < 2 || !web.nearest(path.back(), kFootReachM)) return;
    std::size_t keep = path.size();
    while (keep > 1 && web.nearest(path[keep - 1], kMeetM))
        --keep;
    const auto foot = web.nearest(path[keep - 1], kFootReachM);
    if (!foot) return;
    path.resize(keep);
    const glm::dvec2 away = path.back() - foot->place;
    const double lengthM = glm::length(away);
    if (lengthM > 1.5 * kMeetM) path.push_back(foot->place + kMeetM / lengthM * away);
    path.push_back(foot->place);
}

/// Builds the parts of a way where no road is.
void buildRoad(const std::vector<glm::dvec2>& way, std::string_view kind, RoadSearch& search, WayWeb& web)
{
    std::vector<std::vector<glm::dvec2>> parts;
    for (std::size_t i = 0; i + 1 < way.size(); ++i)
    {
        const bool isThere = search.isUsed(way[i]) && search.isUsed(way[i + 1]);
        if (isThere) continue;
        if (parts.empty() || parts.back().back() != way[i]) parts.push_back({way[i]});
        parts.back().push_back(way[i + 1]);
    }
    for (std::vector<glm::dvec2>& part : parts)
    {
        const bool startsOnRoad = search.isUsed(part.front()), endsOnRoad = search.isUsed(part.back());
        std::vector<glm::dvec2> path = smoothPath(part);
        if (endsOnRoad) meetWeb(path, web);
        std::reverse(path.begin(), path.end());
        if (startsOnRoad) meetWeb(path, web);
        if (path.size() < 2 || lengthOf(path) < kShortestRoadM) continue;
        web.add({kind, roundedPath(path), -1});
    }
    search.use(way);
}

} // namespace

std::vector<std::pair<std::size_t, std::size_t>> neighboursOf(const std::vector<Settlement>& settlements)
{
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t a = 0; a < settlements.size(); ++a)
        for (std::size_t b = a + 1; b < settlements.size(); ++b)
        {
            const glm::dvec2 from = settlements[a].middle, to = settlements[b].middle;
            const bool isFree =
                std::none_of(settlements.begin(), settlements.end(),
                             [&](const Settlement& third)
                             {
                                 return third.middle != from && third.middle != to &&
                                        glm::dot(from - third.middle, to - third.middle) < 0.0;
                             });
            if (isFree) pairs.emplace_back(a, b);
        }
    return pairs;
}

std::size_t planRoads(const std::vector<Settlement>& settlements, RoadSearch& search, WayWeb& web)
{
    auto pairs = neighboursOf(settlements);
    const auto rank = [&](const std::pair<std::size_t, std::size_t>& pair)
    {
        const Settlement &a = settlements[pair.first], &b = settlements[pair.second];
        return std::pair(std::max(a.kind, b.kind), glm::distance(a.middle, b.middle));
    };
    std::stable_sort(pairs.begin(), pairs.end(),
                     [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    std::set<std::size_t> reached;
    for (const auto& [a, b] : pairs)
    {
        const auto way = search.path(settlements[a].middle, settlements[b].middle);
        if (way.size() < 2) continue;
        buildRoad(way, roadKindOf(settlements[a], settlements[b]), search, web);
        reached.insert({a, b});
    }
    return settlements.size() - reached.size();
}

bool joinToWeb(const glm::dvec2& from, std::string_view kind, RoadSearch& search, WayWeb& web)
{
    const auto road = web.nearest(from, 8000.0);
    if (!road) return false;
    const auto way = search.path(from, road->place);
    if (way.size() < 2) return false;
    std::vector<glm::dvec2> whole = way;
    whole.front() = from;
    std::vector<glm::dvec2> path = smoothPath(whole);
    meetWeb(path, web);
    if (path.size() < 2 || !web.nearest(path.back(), 0.01)) return false;
    web.add({kind, roundedPath(path), -1});
    search.use(way);
    return true;
}

} // namespace worldmaking
