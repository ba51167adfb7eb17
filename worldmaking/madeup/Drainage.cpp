// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/Drainage.h"

#include <algorithm>
#include <queue>
#include <tuple>
#include <utility>

namespace worldmaking
{

namespace
{

constexpr int kNowhere = -1, kUnseen = -2;

} // namespace

Drainage::Drainage(const GroundGrid& ground)
    : _ground(ground), _below(ground.size(), kUnseen), _areaKm2(ground.size(), 0.0F)
{
    using Place = std::tuple<double, int>; // height of the flood, point
    std::priority_queue<Place, std::vector<Place>, std::greater<>> flood;
    const int columns = ground.columns(), rows = ground.rows();
    const auto isSea = [&](int column, int row)
    { return !ground.hasGround(column, row) || (ground.hasSea() && ground.heightAt(column, row) <= 0.0); };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
        {
            const bool isRim = row == 0 || column == 0 || row == rows - 1 || column == columns - 1;
            if (!isRim && !isSea(column, row)) continue;
            const int point = static_cast<int>(ground.index(column, row));
            _below[static_cast<std::size_t>(point)] = kNowhere;
            flood.emplace(ground.heightAt(column, row), point);
        }
    _order.reserve(ground.size());
    while (!flood.empty())
    {
        const auto [level, point] = flood.top();
        flood.pop();
        _order.push_back(point);
        const int column = point % columns, row = point / columns;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
            {
                const int x = column + dx, y = row + dy;
                if (x < 0 || y < 0 || x >= columns || y >= rows) continue;
                const std::size_t next = ground.index(x, y);
                if (_below[next] != kUnseen) continue;
                _below[next] = point;
                flood.emplace(std::max(level, ground.heightAt(x, y)), static_cast<int>(next));
            }
    }
    const auto cellKm2 = static_cast<float>(ground.cellM() * ground.cellM() * 1e-6);
    for (auto point = _order.rbegin(); point != _order.rend(); ++point)
    {
        const auto at = static_cast<std::size_t>(*point);
        _areaKm2[at] += cellKm2;
        if (_below[at] >= 0) _areaKm2[static_cast<std::size_t>(_below[at])] += _areaKm2[at];
    }
}

double Drainage::areaKm2(const glm::dvec2& place) const
{
    const glm::dvec2 at = glm::round((place - _ground.box().low) / _ground.cellM());
    if (!(at.x >= 0.0 && at.y >= 0.0 && at.x < _ground.columns() && at.y < _ground.rows())) return 0.0;
    return _areaKm2[_ground.index(static_cast<int>(at.x), static_cast<int>(at.y))];
}

std::vector<Stream> Drainage::streams(double leastKm2) const
{
    const auto isWet = [&](int point)
    {
        const auto at = static_cast<std::size_t>(point);
        return _areaKm2[at] > leastKm2 && _below[at] >= 0;
    };
    std::vector<char> hasWetAbove(_below.size(), 0), isTaken(_below.size(), 0);
    for (std::size_t i = 0; i < _below.size(); ++i)
        if (_below[i] >= 0 && isWet(static_cast<int>(i)))
            hasWetAbove[static_cast<std::size_t>(_below[i])] = 1;
    std::vector<std::pair<double, int>> springs; // the longest way first keeps large rivers in one piece
    for (const int point : _order)
        if (isWet(point) && !hasWetAbove[static_cast<std::size_t>(point)])
        {
            double length = 0.0;
            for (int at = point; at >= 0; at = _below[static_cast<std::size_t>(at)])
                length += 1.0;
            springs.emplace_back(-length, point);
        }
    std::sort(springs.begin(), springs.end());
    std::vector<Stream> streams;
    for (const auto& [length, spring] : springs)
    {
        Stream stream;
        for (int at = spring; at >= 0; at = _below[static_cast<std::size_t>(at)])
        {
            stream.points.push_back(_ground.placeOf(at % _ground.columns(), at / _ground.columns()));
            if (isTaken[static_cast<std::size_t>(at)]) break;
            isTaken[static_cast<std::size_t>(at)] = 1;
            stream.areaKm2 = std::max(stream.areaKm2, 1.0 * _areaKm2[static_cast<std::size_t>(at)]);
        }
        if (stream.points.size() > 4) streams.push_back(std::move(stream));
    }
    return streams;
}

} // namespace worldmaking
