// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <numbers>
#include <unordered_set>

#include <foundation/Random.h>

#include <osgMultiTriangulation/core/input/PointDistribution.h>

namespace osgMultiTriangulation::core
{

namespace
{

/// Random numbers, the same on every machine.
class Numbers
{
public:
    explicit Numbers(std::uint64_t seed) : _bits(seed) {}

    std::uint64_t next() { return _bits(); }

    /// Above 0 and below 1.
    double unit() { return (static_cast<double>(next() >> 12) + 0.5) * 0x1p-52; }

    /// The sum of twelve: nearly normal, with a deviation of 1, and the same on every machine.
    double normal()
    {
        double sum = -6.0;
        for (int i = 0; i < 12; ++i)
            sum += unit();
        return sum;
    }

    double laplace()
    {
        const double u = unit() - 0.5;
        return (u < 0.0 ? 1.0 : -1.0) * std::log(1.0 - 2.0 * std::abs(u)) / std::numbers::sqrt2;
    }

private:
    foundation::SplitMix64 _bits;
};

double hillHeight(double x, double y)
{
    const double height = 300.0 * std::sin(9.0 * x) * std::cos(7.0 * y) +
                          80.0 * std::sin(31.0 * x + 23.0 * y) +
                          20.0 * std::sin(101.0 * x) * std::sin(97.0 * y);
    return std::floor(height * 64.0) / 64.0;
}

/// Makes one point after the other.
class PointMaker
{
public:
    PointMaker(PointDistribution distribution, std::uint64_t seed)
        : _distribution(distribution), _numbers(seed)
    {
        for (auto& cluster : _clusters)
            cluster = {0.1 + 0.8 * _numbers.unit(), 0.1 + 0.8 * _numbers.unit()};
    }

    SurfacePoint next()
    {
        while (true)
        {
            const auto& cluster = _clusters[_numbers.next() % _clusters.size()];
            double at[2];
            for (int axis = 0; axis < 2; ++axis)
                at[axis] = coordinate(cluster[axis]);
            if (!(at[0] > 0.0 && at[0] < 1.0 && at[1] > 0.0 && at[1] < 1.0)) continue;
            return {static_cast<std::int32_t>(at[0] * kMostPlan),
                    static_cast<std::int32_t>(at[1] * kMostPlan), hillHeight(at[0], at[1])};
        }
    }

private:
    double coordinate(double cluster)
    {
        switch (_distribution)
        {
        case PointDistribution::uniform:
            return _numbers.unit();
        case PointDistribution::normal:
            return 0.5 + _numbers.normal() / 8.0;
        case PointDistribution::laplace:
            return 0.5 + _numbers.laplace() / 8.0;
        case PointDistribution::clustered:
            break;
        }
        return cluster + _numbers.normal() / 60.0;
    }

    PointDistribution _distribution;
    Numbers _numbers;
    std::array<std::array<double, 2>, 20> _clusters;
};

} // namespace

void streamMadeUpPoints(PointDistribution distribution, std::size_t count,
                        const std::function<void(const SurfacePoint&)>& visit, std::uint64_t seed)
{
    PointMaker maker(distribution, seed);
    for (std::size_t i = 0; i < count; ++i)
        visit(maker.next());
}

std::vector<SurfacePoint> madeUpPoints(PointDistribution distribution, std::size_t count, std::uint64_t seed)
{
    PointMaker maker(distribution, seed);
    std::vector<SurfacePoint> points;
    points.reserve(count);
    std::unordered_set<std::uint64_t> taken;
    taken.reserve(count);
    while (points.size() < count)
    {
        const SurfacePoint point = maker.next();
        if (taken.insert(std::uint64_t(point.x) << 32 | std::uint32_t(point.y)).second)
            points.push_back(point);
    }
    return points;
}

} // namespace osgMultiTriangulation::core
