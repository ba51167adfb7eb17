// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <osgMultiTriangulation/core/split/Partition.h>

namespace osgMultiTriangulation::core
{

namespace
{

double coordinateOf(const SurfacePoint& point, std::uint32_t axis)
{
    return axis == 0 ? point.x : point.y;
}

/// What a pass tells of the points of a part.
struct PartFigures
{
    std::uint64_t count = 0;
    double sum[2] = {0.0, 0.0};
    double least[2] = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    double most[2] = {-1.0, -1.0};
    double low[2] = {0.0, 0.0}, high[2] = {0.0, 0.0}; ///< its rectangle

    void add(const SurfacePoint& point)
    {
        ++count;
        for (std::uint32_t axis = 0; axis < 2; ++axis)
        {
            const double at = coordinateOf(point, axis);
            sum[axis] += at;
            least[axis] = std::min(least[axis], at);
            most[axis] = std::max(most[axis], at);
        }
    }
};

/// Divides level by level: a pass over all points gives the figures of all parts of a level.
class Divider
{
public:
    Divider(const PointScan& scan, double target, SplitAt where) : _scan(scan), _target(target), _where(where)
    {
    }

    Partition divide()
    {
        _result.parts.emplace_back();
        _figures.emplace_back();
        measure(0);
        for (int axis = 0; axis < 2; ++axis)
        {
            _figures[0].low[axis] = _figures[0].least[axis];
            _figures[0].high[axis] = _figures[0].most[axis];
        }
        for (std::size_t first = 0; first < _result.parts.size();)
        {
            const std::size_t end = _result.parts.size();
            cutAll(first, end);
            if (_result.parts.size() > end) measure(end);
            first = end;
        }
        return numbered();
    }

private:
    /// Counts the points of the parts from `first` on.
    void measure(std::size_t first)
    {
        _scan(
            [&](std::span<const SurfacePoint> points)
            {
                for (const SurfacePoint& point : points)
                    if (const std::uint32_t part = _result.partAt(point); part >= first)
                        _figures[part].add(point);
            });
        for (std::size_t part = first; part < _figures.size(); ++part)
            _result.parts[part].points = static_cast<std::uint32_t>(_figures[part].count);
    }

    /// Halves the parts of a level that are not done: across the longer side or, where all points are on one
    /// line, the other.
    void cutAll(std::size_t first, std::size_t end)
    {
        std::vector<std::uint32_t> axes(end - first, 2); // 2: is not halved
        for (std::size_t part = first; part < end; ++part)
        {
            const PartFigures& own = _figures[part];
            const auto count = static_cast<double>(own.count);
            if (std::abs(count - _target) <= std::abs(count / 2.0 - _target)) continue;
            const std::uint32_t longer = own.high[0] - own.low[0] >= own.high[1] - own.low[1] ? 0 : 1;
            for (const std::uint32_t axis : {1 - longer, longer})
                if (own.least[axis] < own.most[axis]) axes[part - first] = axis;
        }
        std::vector<double> cuts(end - first);
        for (std::size_t part = first; part < end; ++part)
            if (axes[part - first] < 2)
                cuts[part - first] =
                    _figures[part].sum[axes[part - first]] / static_cast<double>(_figures[part].count);
        if (_where == SplitAt::median) cutAtMedians(first, axes, cuts);
        for (std::size_t part = first; part < end; ++part)
            if (axes[part - first] < 2) halve(part, axes[part - first], cuts[part - first]);
    }

    void halve(std::size_t number, std::uint32_t axis, double cut)
    {
        _result.parts[number].axis = axis;
        _result.parts[number].cut = cut;
        for (int side = 0; side < 2; ++side)
        {
            PlanPart half;
            half.parent = static_cast<std::uint32_t>(number);
            half.depth = _result.parts[number].depth + 1;
            _result.parts[number].halves[side] = static_cast<std::uint32_t>(_result.parts.size());
            PartFigures figures;
            for (int a = 0; a < 2; ++a)
            {
                figures.low[a] = _figures[number].low[a];
                figures.high[a] = _figures[number].high[a];
            }
            (side == 0 ? figures.high : figures.low)[axis] = cut;
            _result.parts.push_back(half);
            _figures.push_back(figures);
        }
    }

    /// Takes medians for cuts. Where nothing is below one, that of the other axis; where that is no better,
    /// the part is not halved.
    void cutAtMedians(std::size_t first, std::vector<std::uint32_t>& axes, std::vector<double>& cuts)
    {
        findMedians(first, axes, cuts);
        std::vector<std::uint32_t> others(axes.size(), 2);
        for (std::size_t part = 0; part < axes.size(); ++part)
        {
            if (axes[part] == 2 || cuts[part] > _figures[first + part].least[axes[part]]) continue;
            others[part] = 1 - axes[part];
            axes[part] = 2;
        }
        if (std::ranges::all_of(others, [](std::uint32_t axis) { return axis == 2; })) return;
        std::vector<double> otherCuts(cuts.size());
        findMedians(first, others, otherCuts);
        for (std::size_t part = 0; part < axes.size(); ++part)
        {
            if (others[part] == 2 || otherCuts[part] <= _figures[first + part].least[others[part]]) continue;
            axes[part] = others[part];
            cuts[part] = otherCuts[part];
        }
    }

    /// Finds the coordinate of the middle point of each part along its axis, nine bits a pass.
    void findMedians(std::size_t first, std::span<const std::uint32_t> axes, std::vector<double>& cuts)
    {
        constexpr std::uint32_t kBits = 9, kPasses = 3, kBins = 1u << kBits;
        std::vector<std::uint32_t> found(axes.size(), 0); // the upper bits of the median
        std::vector<std::uint64_t> before(
            axes.size()); // points that are still below it among those with these bits
        for (std::size_t part = 0; part < axes.size(); ++part)
            before[part] = _figures[first + part].count / 2;
        for (std::uint32_t pass = kPasses; pass-- > 0;)
        {
            const std::uint32_t shift = pass * kBits;
            std::vector<std::array<std::uint32_t, kBins>> bins(axes.size());
            _scan(
                [&](std::span<const SurfacePoint> points)
                {
                    for (const SurfacePoint& point : points)
                    {
                        const std::size_t part = _result.partAt(point) - first;
                        if (part >= axes.size() || axes[part] == 2) continue;
                        const auto at = static_cast<std::uint32_t>(coordinateOf(point, axes[part]));
                        if (at >> shift >> kBits == found[part]) ++bins[part][at >> shift & (kBins - 1)];
                    }
                });
            for (std::size_t part = 0; part < axes.size(); ++part)
            {
                std::uint32_t bin = 0;
                while (bin + 1 < kBins && before[part] >= bins[part][bin])
                    before[part] -= bins[part][bin++];
                found[part] = found[part] << kBits | bin;
            }
        }
        for (std::size_t part = 0; part < axes.size(); ++part)
            cuts[part] = found[part];
    }

    /// Numbers parts so that those of one half follow each other.
    Partition numbered() const
    {
        Partition partition;
        std::vector<std::uint32_t> old{0}, open{0}; // old: by new number
        while (!open.empty())
        {
            const std::uint32_t number = open.back();
            open.pop_back();
            const PlanPart& part = _result.parts[old[number]];
            if (part.isWhole()) ++partition.rectangles;
            for (const std::uint32_t half : part.halves)
                if (half != kNone)
                {
                    open.push_back(static_cast<std::uint32_t>(old.size()));
                    old.push_back(half);
                }
        }
        std::vector<std::uint32_t> numbers(old.size());
        for (std::uint32_t number = 0; number < old.size(); ++number)
            numbers[old[number]] = number;
        for (const std::uint32_t from : old)
        {
            PlanPart part = _result.parts[from];
            for (std::uint32_t* link : {&part.parent, &part.halves[0], &part.halves[1]})
                if (*link != kNone) *link = numbers[*link];
            partition.parts.push_back(part);
        }
        return partition;
    }

    const PointScan& _scan;
    double _target;
    SplitAt _where;
    Partition _result;
    std::vector<PartFigures> _figures; ///< by part
};

} // namespace

std::uint32_t Partition::partAt(const SurfacePoint& point) const
{
    std::uint32_t part = 0;
    while (!parts[part].isWhole())
        part = parts[part].halves[coordinateOf(point, parts[part].axis) < parts[part].cut ? 0 : 1];
    return part;
}

std::uint32_t Partition::common(std::uint32_t a, std::uint32_t b) const
{
    while (a != b)
    {
        std::uint32_t& deeper = parts[a].depth >= parts[b].depth ? a : b;
        deeper = parts[deeper].parent;
    }
    return a;
}

Partition partitionPoints(const PointScan& scan, double target, SplitAt where)
{
    return Divider(scan, target, where).divide();
}

Partition partitionPoints(std::span<const SurfacePoint> points, double target, SplitAt where)
{
    return partitionPoints([points](const auto& visit) { visit(points); }, target, where);
}

} // namespace osgMultiTriangulation::core
