// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include <osgMultiTriangulation/core/split/Partition.h>

namespace osgMultiTriangulation::core
{

namespace
{

/// A run of point numbers to be divided.
struct OpenPart
{
    std::uint32_t number, first, last;
    double low[2], high[2]; ///< of its rectangle
};

class Divider
{
public:
    Divider(std::span<const SurfacePoint> points, double target, SplitAt where)
        : _points(points), _target(target), _where(where), _order(points.size())
    {
        std::iota(_order.begin(), _order.end(), 0u);
    }

    Partition divide()
    {
        _result.partOf.assign(_points.size(), 0);
        OpenPart all{0, 0, static_cast<std::uint32_t>(_points.size()), {0, 0}, {0, 0}};
        for (int axis = 0; axis < 2; ++axis)
            for (std::size_t i = 0; i < _points.size(); ++i)
            {
                const double at = coordinate(static_cast<std::uint32_t>(i), axis);
                all.low[axis] = i == 0 ? at : std::min(all.low[axis], at);
                all.high[axis] = i == 0 ? at : std::max(all.high[axis], at);
            }
        _result.parts.push_back({kNone, {kNone, kNone}, 0, all.last});
        std::vector<OpenPart> open{all};
        while (!open.empty())
        {
            const OpenPart part = open.back();
            open.pop_back();
            if (!halve(part, open)) close(part);
        }
        return std::move(_result);
    }

private:
    double coordinate(std::uint32_t point, int axis) const
    {
        return axis == 0 ? _points[point].x : _points[point].y;
    }

    bool halve(const OpenPart& part, std::vector<OpenPart>& open)
    {
        const double count = part.last - part.first;
        if (std::abs(count - _target) <= std::abs(count / 2.0 - _target)) return false;
        const int longer = part.high[0] - part.low[0] >= part.high[1] - part.low[1] ? 0 : 1;
        for (const int axis : {longer, 1 - longer})
        {
            const double cut = cutOf(part, axis);
            const auto begin = _order.begin() + part.first, end = _order.begin() + part.last;
            const auto middle =
                std::partition(begin, end, [&](std::uint32_t p) { return coordinate(p, axis) < cut; });
            if (middle == begin || middle == end)
                continue; // all points on one line: try across the other side
            OpenPart half[2] = {part, part};
            half[0].last = half[1].first = static_cast<std::uint32_t>(middle - _order.begin());
            half[0].high[axis] = half[1].low[axis] = cut;
            for (int side = 0; side < 2; ++side)
            {
                half[side].number = static_cast<std::uint32_t>(_result.parts.size());
                _result.parts[part.number].halves[side] = half[side].number;
                _result.parts.push_back({part.number,
                                         {kNone, kNone},
                                         _result.parts[part.number].depth + 1,
                                         half[side].last - half[side].first});
                open.push_back(half[side]);
            }
            return true;
        }
        return false;
    }

    /// Points below it lie in the lower half.
    double cutOf(const OpenPart& part, int axis)
    {
        const auto begin = _order.begin() + part.first, end = _order.begin() + part.last;
        if (_where == SplitAt::median)
        {
            const auto middle = begin + (end - begin) / 2;
            std::nth_element(begin, middle, end,
                             [&](std::uint32_t a, std::uint32_t b)
                             { return coordinate(a, axis) < coordinate(b, axis); });
            return coordinate(*middle, axis);
        }
        double sum = 0.0;
        for (auto p = begin; p != end; ++p)
            sum += coordinate(*p, axis);
        return sum / static_cast<double>(end - begin);
    }

    void close(const OpenPart& part)
    {
        ++_result.rectangles;
        for (std::uint32_t i = part.first; i < part.last; ++i)
            _result.partOf[_order[i]] = part.number;
    }

    std::span<const SurfacePoint> _points;
    double _target;
    SplitAt _where;
    std::vector<std::uint32_t> _order;
    Partition _result;
};

} // namespace

std::uint32_t Partition::common(std::uint32_t a, std::uint32_t b) const
{
    while (a != b)
    {
        std::uint32_t& deeper = parts[a].depth >= parts[b].depth ? a : b;
        deeper = parts[deeper].parent;
    }
    return a;
}

Partition partitionPoints(std::span<const SurfacePoint> points, double target, SplitAt where)
{
    return Divider(points, target, where).divide();
}

} // namespace osgMultiTriangulation::core
