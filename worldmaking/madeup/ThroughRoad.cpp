// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/ThroughRoad.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "worldmaking/madeup/SmoothPath.h"

namespace worldmaking
{

namespace
{

constexpr int kWaysOut = 16;
constexpr double kRayStepM = 20.0, kLeastThroughM = 400.0;

/// The places along rays that a road can reach.
class Rays
{
public:
    Rays(const MapBox& box, const RoadSearch& search) : _box(box), _search(search) {}

    std::optional<glm::dvec2> nearest(const glm::dvec2& from) const
    {
        std::optional<glm::dvec2> found;
        for (int ray = 0; ray < kWaysOut; ++ray)
            if (const auto near = along(from, ray, true);
                near && (!found || glm::distance(*near, from) < glm::distance(*found, from)))
                found = near;
        return found;
    }

    std::optional<glm::dvec2> farthest(const glm::dvec2& from, int ray) const
    {
        return along(from, ray, false);
    }

private:
    std::optional<glm::dvec2> along(const glm::dvec2& from, int ray, bool isFirst) const
    {
        const double angle = 2.0 * std::numbers::pi * ray / kWaysOut;
        const glm::dvec2 way(std::cos(angle), std::sin(angle));
        std::optional<glm::dvec2> found;
        for (double away = 0.0; away < glm::distance(_box.low, _box.high); away += kRayStepM)
        {
            const glm::dvec2 at = from + away * way;
            if (!glm::all(glm::greaterThanEqual(at, _box.low)) ||
                !glm::all(glm::lessThanEqual(at, _box.high)) || !_search.isReachable(at))
                continue;
            found = at;
            if (isFirst) break;
        }
        return found;
    }

    const MapBox& _box;
    const RoadSearch& _search;
};

/// The two ways out, as one, that bend least.
std::vector<glm::dvec2> straightest(const std::vector<std::vector<glm::dvec2>>& ways)
{
    std::vector<glm::dvec2> best;
    double least = 1e300;
    for (std::size_t a = 0; a < ways.size(); ++a)
        for (std::size_t b = a + 1; b < ways.size(); ++b)
        {
            const double straightM = glm::distance(ways[a].back(), ways[b].back());
            const double bend = (lengthOf(ways[a]) + lengthOf(ways[b])) / std::max(straightM, 1.0);
            if (bend >= least || straightM < kLeastThroughM) continue;
            least = bend;
            best.assign(ways[a].rbegin(), ways[a].rend());
            best.insert(best.end(), ways[b].begin() + 1, ways[b].end());
        }
    return best;
}

} // namespace

bool roadThrough(const glm::dvec2& place, const MapBox& box, std::string_view kind, RoadSearch& search,
                 WayWeb& web)
{
    const Rays rays(box, search);
    const auto start = rays.nearest(place);
    if (!start) return false;
    std::vector<std::vector<glm::dvec2>> ways;
    for (int ray = 0; ray < kWaysOut; ++ray)
        if (const auto edge = rays.farthest(*start, ray))
            if (auto way = search.path(*start, *edge); way.size() > 1) ways.push_back(std::move(way));
    const std::vector<glm::dvec2> best = straightest(ways);
    if (best.empty()) return false;
    web.add({kind, roundedPath(smoothPath(best)), -1});
    search.use(best);
    return true;
}

} // namespace worldmaking
