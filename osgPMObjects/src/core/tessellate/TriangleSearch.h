// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace osgPMObjects::core
{

/// Finds the points near a triangle by a grid with about as many cells as points. It visits the cells row by
/// row as the triangle covers them, for the bounding box of a long diagonal triangle has many more.
/// Memory: 12 B a point. Cost: linear to build; a query visits the cells that the triangle covers.
class TriangleSearch
{
public:
    struct Entry
    {
        std::uint32_t number;
        glm::dvec2 position;
    };

    /// What to do after a point was found.
    enum class Verdict
    {
        goOn,
        takeOut, ///< remove the point, and go on
        stop,
    };

    explicit TriangleSearch(std::span<const Entry> entries)
    {
        if (!entries.empty()) _low = _high = entries.front().position;
        for (const Entry& e : entries)
            _low = glm::min(_low, e.position), _high = glm::max(_high, e.position);
        _side = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(entries.size()))));
        const glm::dvec2 size = _high - _low;
        for (int axis : {0, 1})
            _perUnit[axis] = size[axis] > 0.0 ? _side / size[axis] : 0.0;
        _first.assign(static_cast<std::size_t>(_side) * static_cast<std::size_t>(_side), kNone);
        for (const Entry& e : entries)
            add(e);
    }

    void add(const Entry& entry)
    {
        std::uint32_t& first = _first[cellAt(columnOf(entry.position.x), rowOf(entry.position.y))];
        _next.push_back(first);
        _numbers.push_back(entry.number);
        first = static_cast<std::uint32_t>(_next.size() - 1);
    }

    /// Calls `judge(number)` for all points in or on a triangle, and for some others, until it says stop.
    /// Returns whether it did.
    template<class Judge>
    bool visit(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const Judge& judge)
    {
        const auto [lowX, highX] = std::minmax({a.x, b.x, c.x});
        const auto [lowY, highY] = std::minmax({a.y, b.y, c.y});
        const int left = columnOf(lowX), right = columnOf(highX), top = rowOf(highY);
        for (int row = rowOf(lowY); row <= top; ++row)
        {
            int from = left, to = right;
            if (right - left > kWide)
            {
                const auto [low, high] = extentIn(row, a, b, c);
                from = std::max(left, columnOf(low) - 1);
                to = std::min(right, columnOf(high) + 1);
            }
            for (int column = from; column <= to; ++column)
                if (visitCell(cellAt(column, row), judge)) return true;
        }
        return false;
    }

private:
    static constexpr std::uint32_t kNone = ~0u;
    static constexpr int kWide = 4; ///< wider triangles are clipped to each row

    int columnOf(double x) const { return cellOf((x - _low.x) * _perUnit.x); }
    int rowOf(double y) const { return cellOf((y - _low.y) * _perUnit.y); }
    int cellOf(double x) const { return static_cast<int>(std::clamp(x, 0.0, _side - 1.0)); }
    std::size_t cellAt(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(_side) +
               static_cast<std::size_t>(column);
    }

    /// Returns the extent of a triangle within a row, in x.
    std::pair<double, double> extentIn(int row, const glm::dvec2& a, const glm::dvec2& b,
                                       const glm::dvec2& c) const
    {
        constexpr double kRounding =
            1e-6; // of a row: points near its border may have been put into the next row
        const double bottom = _low.y + (row - kRounding) / _perUnit.y;
        const double top = _low.y + (row + 1.0 + kRounding) / _perUnit.y;
        double low = _high.x, high = _low.x;
        const auto take = [&](const glm::dvec2& p, const glm::dvec2& q)
        {
            if (std::max(p.y, q.y) < bottom || std::min(p.y, q.y) > top) return;
            const bool isLevel = p.y == q.y;
            for (const glm::dvec2& end : {p, q})
            {
                const double y = std::clamp(end.y, bottom, top);
                const double x = isLevel ? end.x : p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y));
                low = std::min(low, x);
                high = std::max(high, x);
            }
        };
        take(a, b);
        take(b, c);
        take(c, a);
        return {low, high};
    }

    template<class Judge>
    bool visitCell(std::size_t cell, const Judge& judge)
    {
        for (std::uint32_t* link = &_first[cell]; *link != kNone;)
        {
            const Verdict verdict = judge(_numbers[*link]);
            if (verdict == Verdict::stop) return true;
            if (verdict == Verdict::takeOut)
                *link = _next[*link];
            else
                link = &_next[*link];
        }
        return false;
    }

    glm::dvec2 _low{0.0}, _high{0.0}, _perUnit{0.0};
    int _side = 1;
    std::vector<std::uint32_t> _first;   ///< by cell: its first point
    std::vector<std::uint32_t> _next;    ///< by point: the next one in its cell
    std::vector<std::uint32_t> _numbers; ///< by point
};

} // namespace osgPMObjects::core
