// SPDX-License-Identifier: Apache-2.0
#include "simulation/tour/GentleTrack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "simulation/player/PathCurve.h"

namespace simulation
{
namespace
{

constexpr int kNodesAlong = 256;
constexpr double kMarginShare = 0.4; ///< of the distance, searched on every side
constexpr double kEasyGrade = 0.06;
constexpr double kEasyCrossSlope = 0.10;
constexpr int kRoundingPasses = 6;

constexpr std::array<std::pair<int, int>, 16> kMoves = {{{1, 0},
                                                         {1, 1},
                                                         {0, 1},
                                                         {-1, 1},
                                                         {-1, 0},
                                                         {-1, -1},
                                                         {0, -1},
                                                         {1, -1},
                                                         {2, 1},
                                                         {1, 2},
                                                         {-1, 2},
                                                         {-2, 1},
                                                         {-2, -1},
                                                         {-1, -2},
                                                         {1, -2},
                                                         {2, -1}}};

/// Heights on a square grid around two places.
class TrackGrid
{
public:
    TrackGrid(const TourTerrain& terrain, const glm::dvec2& from, const glm::dvec2& to)
    {
        const double margin = kMarginShare * glm::length(to - from) + 4.0 * terrain.sampleSpacingM;
        const glm::dvec2 low =
            glm::max(glm::min(from, to) - margin, glm::dvec2(terrain.westM, terrain.southM));
        const glm::dvec2 high =
            glm::min(glm::max(from, to) + margin, glm::dvec2(terrain.eastM, terrain.northM));
        const glm::dvec2 size = high - low;
        _cellM = std::max(0.5 * terrain.sampleSpacingM, std::max(size.x, size.y) / (kNodesAlong - 1));
        _low = low;
        _columns = std::max(2, static_cast<int>(size.x / _cellM) + 1);
        _rows = std::max(2, static_cast<int>(size.y / _cellM) + 1);
        for (int row = 0; row < _rows; ++row)
            for (int column = 0; column < _columns; ++column)
            {
                const glm::dvec2 at = place(node(column, row));
                _heights.push_back(terrain.heightM(at.x, at.y));
            }
    }

    int count() const { return _columns * _rows; }
    int node(int column, int row) const { return row * _columns + column; }
    int nearest(const glm::dvec2& at) const
    {
        const glm::dvec2 grid = (at - _low) / _cellM;
        return node(std::clamp(static_cast<int>(std::lround(grid.x)), 0, _columns - 1),
                    std::clamp(static_cast<int>(std::lround(grid.y)), 0, _rows - 1));
    }
    glm::dvec2 place(int index) const
    {
        return _low + _cellM * glm::dvec2(index % _columns, index / _columns);
    }

    /// The node after a move; -1 beyond the grid.
    int after(int index, const std::pair<int, int>& move) const
    {
        const int column = index % _columns + move.first;
        const int row = index / _columns + move.second;
        return column < 0 || row < 0 || column >= _columns || row >= _rows ? -1 : node(column, row);
    }

    double cost(int from, int to) const
    {
        const glm::dvec2 way = place(to) - place(from);
        const double length = glm::length(way);
        const double grade = (height(to) - height(from)) / length;
        const glm::dvec2 slope = 0.5 * (gradient(from) + gradient(to));
        const double cross = (slope.y * way.x - slope.x * way.y) / length;
        const double g = grade / kEasyGrade;
        const double c = cross / kEasyCrossSlope;
        return length * (1.0 + g * g + c * c);
    }

private:
    double height(int index) const { return _heights[static_cast<std::size_t>(index)]; }

    glm::dvec2 gradient(int index) const
    {
        const int column = index % _columns;
        const int row = index / _columns;
        const int west = std::max(0, column - 1);
        const int east = std::min(_columns - 1, column + 1);
        const int south = std::max(0, row - 1);
        const int north = std::min(_rows - 1, row + 1);
        return {(height(node(east, row)) - height(node(west, row))) / ((east - west) * _cellM),
                (height(node(column, north)) - height(node(column, south))) / ((north - south) * _cellM)};
    }

    glm::dvec2 _low{0.0};
    double _cellM = 1.0;
    int _columns = 0;
    int _rows = 0;
    std::vector<double> _heights;
};

std::vector<int> cheapestWay(const TrackGrid& grid, int from, int to)
{
    using Entry = std::pair<double, int>; // cost, node: ties go to the smaller index
    std::vector<double> costs(static_cast<std::size_t>(grid.count()),
                              std::numeric_limits<double>::infinity());
    std::vector<int> before(costs.size(), -1);
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    costs[static_cast<std::size_t>(from)] = 0.0;
    open.emplace(0.0, from);
    while (!open.empty() && open.top().second != to)
    {
        const auto [cost, node] = open.top();
        open.pop();
        if (cost > costs[static_cast<std::size_t>(node)]) continue;
        for (const std::pair<int, int>& move : kMoves)
        {
            const int next = grid.after(node, move);
            if (next < 0) continue;
            const double there = cost + grid.cost(node, next);
            if (there >= costs[static_cast<std::size_t>(next)]) continue;
            costs[static_cast<std::size_t>(next)] = there;
            before[static_cast<std::size_t>(next)] = node;
            open.emplace(there, next);
        }
    }
    std::vector<int> way;
    for (int node = to; node >= 0; node = before[static_cast<std::size_t>(node)])
        way.push_back(node);
    std::reverse(way.begin(), way.end());
    return way;
}

std::vector<glm::dvec2> evenly(const std::vector<glm::dvec2>& places, double spacingM)
{
    std::vector<PathVertex> vertices;
    for (const glm::dvec2& place : places)
    {
        const double chord =
            vertices.empty() ? 0.0 : glm::length(glm::dvec3(place, 0.0) - vertices.back().position);
        if (!vertices.empty() && chord < 1e-6) continue;
        vertices.push_back(
            {vertices.empty() ? 0.0 : vertices.back().parameter + chord, glm::dvec3(place, 0.0), {}});
    }
    if (vertices.size() < 2) return places;
    const PathCurve curve(vertices, FollowingMode::follow, std::nullopt);
    const int pieces = std::max(1, static_cast<int>(std::lround(curve.lengthM() / spacingM)));
    std::vector<glm::dvec2> even;
    for (int i = 0; i <= pieces; ++i)
        even.push_back(glm::dvec2(curve.at(curve.parameterAt(curve.lengthM() * i / pieces)).position));
    return even;
}

} // namespace

std::vector<glm::dvec2> gentleTrack(const TourTerrain& terrain, const glm::dvec2& from, const glm::dvec2& to,
                                    double spacingM)
{
    const TrackGrid grid(terrain, from, to);
    std::vector<glm::dvec2> places{from};
    const std::vector<int> way = cheapestWay(grid, grid.nearest(from), grid.nearest(to));
    for (std::size_t i = 1; i + 1 < way.size(); ++i)
        places.push_back(grid.place(way[i]));
    places.push_back(to);
    places = evenly(places, spacingM);
    // Each pass moves every place to the mean of itself and its neighbours: the corners of the grid go.
    for (int pass = 0; pass < kRoundingPasses * kRoundingPasses; ++pass)
    {
        const std::vector<glm::dvec2> sharp = places;
        for (std::size_t i = 1; i + 1 < places.size(); ++i)
            places[i] = 0.25 * sharp[i - 1] + 0.5 * sharp[i] + 0.25 * sharp[i + 1];
    }
    return evenly(places, spacingM);
}

} // namespace simulation
