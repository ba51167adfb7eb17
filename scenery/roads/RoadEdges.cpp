// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/RoadEdges.h"

#include <algorithm>
#include <cmath>
#include <thread>
#include <utility>

#include <foundation/Threads.h>
#include <glm/geometric.hpp>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/query/Stations.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

namespace scenery
{

namespace
{

using osgRoads::core::PlacedNetwork;
using osgRoads::core::Road;

constexpr double kEdgeStepM = 3.0;                     ///< between points of an edge
constexpr double kEdgeCellM = 40.0;                    ///< at least the farthest reach
constexpr double kLeastWideM = 6.0, kMostWideM = 24.0; ///< over which half of a rise is gone
constexpr double kWidePerRise = 2.0, kReachPerWide = 1.6;
constexpr double kBeyondEndM = 0.5; ///< to the points beyond the end of a road
constexpr double kOfLine =
    0.75; ///< so that a straight edge weighs 1 at the distance `wide` (its integral is 4/3)
constexpr double kNearestM = 0.3; ///< nearer points weigh as if they were so far away
constexpr double kCoveredM = 0.3; ///< so far within another road's verge an edge is covered

double wideOf(double riseM)
{
    return std::clamp(kWidePerRise * std::abs(riseM), kLeastWideM, kMostWideM);
}

std::uint64_t cellOf(std::int64_t column, std::int64_t row)
{
    return static_cast<std::uint64_t>(row) << 32 | (static_cast<std::uint64_t>(column) & 0xffffffffu);
}

std::pair<std::int64_t, std::int64_t> cellAt(const glm::dvec2& place)
{
    return {static_cast<std::int64_t>(std::floor(place.x / kEdgeCellM)),
            static_cast<std::int64_t>(std::floor(place.y / kEdgeCellM))};
}

} // namespace

struct RoadEdges::Site
{
    glm::dvec3 edge{0.0}; ///< at the verge's outer edge
    double shareM = kEdgeStepM;
};

double RoadEdges::reachOf(double riseM, const RoadCutShape& shape)
{
    return std::min({kReachPerWide * wideOf(riseM), shape.reachM - shape.bed.vergeM, kEdgeCellM});
}

std::vector<RoadEdges::Site> RoadEdges::sitesOf(const PlacedNetwork& roads, int index,
                                                const RoadCutShape& shape)
{
    std::vector<Site> sites;
    const Road& road = roads.road(index);
    if (!road.isUsable) return sites;
    const double fallM = shape.bed.vergeFall * shape.bed.vergeM + shape.vergeEndM;
    const auto stations = osgRoads::core::evenStations(road.length, kEdgeStepM);
    const double shareM = road.length / std::max<double>(1.0, static_cast<double>(stations.size()) - 1.0);
    for (const double s : stations)
    {
        if (osgRoads::core::structureAt(road, s) || (shape.torn && shape.torn->at(index, s))) continue;
        const auto lanes = osgRoads::core::extentAt(road, s);
        const glm::dvec3 left = roads.surfacePoint(index, s, lanes.leftT),
                         right = roads.surfacePoint(index, s, lanes.rightT);
        const glm::dvec2 across = glm::dvec2(left) - glm::dvec2(right);
        const double widthM = glm::length(across);
        if (widthM < 1e-3) continue;
        const glm::dvec3 out(across * (shape.bed.vergeM / widthM), 0.0), down(0.0, 0.0, fallM);
        sites.push_back({left + out - down, shareM});
        sites.push_back({right - out - down, shareM});
        const bool isEnd = (s <= 0.0 && !road.predecessor) || (s >= road.length && !road.successor);
        if (!isEnd) continue;
        const glm::dvec3 middle = roads.surfacePoint(index, s, 0.5 * (lanes.leftT + lanes.rightT));
        const glm::dvec3 inside = roads.surfacePoint(
            index, s <= 0.0 ? kBeyondEndM : road.length - kBeyondEndM, 0.5 * (lanes.leftT + lanes.rightT));
        const glm::dvec3 beyond = glm::dvec3(glm::dvec2(middle - inside), -shape.vergeEndM);
        const int count = static_cast<int>(std::ceil(widthM / kEdgeStepM));
        for (int k = 0; k <= count; ++k)
            sites.push_back(
                {glm::mix(right, left, static_cast<double>(k) / count) + beyond, widthM / (count + 1)});
    }
    return sites;
}

bool RoadEdges::isFree(const PlacedNetwork& roads, const Site& site, const RoadCutShape& shape)
{
    const glm::dvec2 plan(roads.toInertial(site.edge));
    const auto matches = roads.locator().within(plan, shape.bed.vergeM - kCoveredM);
    return std::all_of(matches.begin(), matches.end(),
                       [&](const osgRoads::core::RoadMatch& match)
                       {
                           const auto& [road, s, t, h] = match.position;
                           const auto lanes = osgRoads::core::extentAt(roads.road(road), s);
                           const bool isBeyondEnd =
                               match.distance > 0.0 && t >= lanes.rightT && t <= lanes.leftT;
                           return isBeyondEnd || osgRoads::core::structureAt(roads.road(road), s) != nullptr;
                       });
}

RoadEdges::RoadEdges(const PlacedNetwork& roads, const osgTerrainROAM::core::PlacedTile& tile,
                     const RoadCutShape& shape)
{
    const auto pointAt = [&](const Site& site, Point& point)
    {
        const auto ground = osgTerrainROAM::core::groundAt(tile, site.edge.x, site.edge.y);
        if (!ground || !isFree(roads, site, shape)) return false;
        const double riseM = tile.frame().heightOf(site.edge) - tile.frame().heightOf(ground->position);
        point = {glm::dvec2(site.edge), static_cast<float>(riseM), static_cast<float>(wideOf(riseM)),
                 static_cast<float>(reachOf(riseM, shape)), static_cast<float>(site.shareM)};
        return true;
    };
    const std::size_t count = roads.network().roads.size();
    const std::size_t runs = std::clamp<std::size_t>(foundation::processors(), 1, 8);
    std::vector<std::vector<Point>> found(runs);
    const auto look = [&](std::size_t run)
    {
        for (std::size_t i = count * run / runs; i < count * (run + 1) / runs; ++i)
            for (const Site& site : sitesOf(roads, static_cast<int>(i), shape))
                if (Point point; pointAt(site, point)) found[run].push_back(point);
    };
    foundation::Threads threads;
    for (std::size_t run = 1; run < runs; ++run)
        threads.run([&look, run] { look(run); });
    look(0);
    threads.join();
    for (const auto& some : found)
        _points.insert(_points.end(), some.begin(), some.end());
    fillCells();
}

void RoadEdges::fillCells()
{
    const auto cell = [](const Point& point)
    {
        const auto [column, row] = cellAt(point.place);
        return cellOf(column, row);
    };
    std::stable_sort(_points.begin(), _points.end(),
                     [&](const Point& a, const Point& b) { return cell(a) < cell(b); });
    for (std::uint32_t i = 0; i < _points.size(); ++i)
        _cells.try_emplace(cell(_points[i]), i, i).first->second.second = i + 1;
}

double RoadEdges::riseAt(const glm::dvec2& place) const
{
    const auto [column, row] = cellAt(place);
    double weights = 1.0, sum = 0.0; // the ground as it was weighs 1
    const auto add = [&](const Point& point)
    {
        const glm::dvec2 away = place - point.place;
        const double square = std::max(glm::dot(away, away), kNearestM * kNearestM);
        const double reachM = point.reachM;
        if (square >= reachM * reachM) return;
        const double distanceM = std::sqrt(square), fade = 1.0 - distanceM / reachM;
        const double wide = double{point.wideM} * point.wideM;
        const double weight =
            kOfLine * point.shareM * wide * wide / (square * square * distanceM) * fade * fade;
        weights += weight;
        sum += weight * point.riseM;
    };
    for (std::int64_t r = row - 1; r <= row + 1; ++r)
        for (std::int64_t c = column - 1; c <= column + 1; ++c)
            if (const auto found = _cells.find(cellOf(c, r)); found != _cells.end())
                for (std::uint32_t i = found->second.first; i < found->second.second; ++i)
                    add(_points[i]);
    return sum / weights;
}

} // namespace scenery
