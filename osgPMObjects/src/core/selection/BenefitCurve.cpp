// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osgPMObjects/core/selection/BenefitCurve.h>

namespace osgPMObjects::core
{

namespace
{

double gainByCost(const BenefitPoint& from, const BenefitPoint& to)
{
    return (to.gain - from.gain) / static_cast<double>(to.cost - from.cost);
}

} // namespace

std::uint64_t CostModel::of(std::uint32_t triangles, std::uint32_t vertices) const
{
    return static_cast<std::uint64_t>(std::ceil(perDraw + perTriangle * triangles + perVertex * vertices));
}

BenefitCurve BenefitCurve::of(const LevelTable& table, double radius, const CostModel& cost,
                              const ErrorMeasure& measure, std::uint32_t levels)
{
    double faces = table.faces[coarsestWithin(table, 0.0, measure)];
    const double ratio = std::pow(table.faces.back() / faces, 1.0 / std::max(1u, levels - 1));
    std::vector<std::uint32_t> steps;
    for (std::uint32_t i = 0; i + 1 < levels; ++i, faces *= ratio)
    {
        const auto level = std::partition_point(table.faces.begin(), table.faces.end(),
                                                [&](std::uint32_t f) { return f > faces; });
        steps.push_back(std::min(table.mostSteps(), static_cast<std::uint32_t>(level - table.faces.begin())));
    }
    steps.push_back(table.mostSteps());
    return ofLevels(table, steps, radius, cost, measure);
}

BenefitCurve BenefitCurve::ofLevels(const LevelTable& table, std::span<const std::uint32_t> levels,
                                    double radius, const CostModel& cost, const ErrorMeasure& measure)
{
    const auto errorAfter = [&](std::uint32_t steps)
    { return errorOf(table.errorAfter(steps, measure.kind), measure.weights); };
    const auto accuracy = [&](std::uint32_t steps)
    { return 1.0 - std::min(1.0, errorAfter(steps) / radius); };
    const double least = accuracy(table.mostSteps());
    std::vector<BenefitPoint> points;
    for (const std::uint32_t steps : levels)
    {
        const std::uint32_t vertices = table.positions > steps ? table.positions - steps : 0;
        points.push_back(
            {steps, cost.of(table.faces[steps], vertices), accuracy(steps) - least, errorAfter(steps)});
    }
    return hullOf(std::move(points));
}

BenefitCurve BenefitCurve::hullOf(std::vector<BenefitPoint> points)
{
    std::sort(points.begin(), points.end(),
              [](const BenefitPoint& a, const BenefitPoint& b)
              { return a.cost != b.cost ? a.cost < b.cost : a.gain > b.gain; });
    BenefitCurve curve;
    auto& hull = curve.points;
    for (const BenefitPoint& point : points)
    {
        if (!hull.empty() && point.gain <= hull.back().gain) continue;
        while (hull.size() > 1 &&
               gainByCost(hull[hull.size() - 2], hull.back()) <= gainByCost(hull.back(), point))
            hull.pop_back();
        hull.push_back(point);
    }
    return curve;
}

bool isBenefitCurve(const BenefitCurve& curve)
{
    const auto& p = curve.points;
    for (std::size_t i = 1; i < p.size(); ++i)
    {
        if (p[i].cost <= p[i - 1].cost || p[i].gain <= p[i - 1].gain) return false;
        if (i > 1 && gainByCost(p[i - 1], p[i]) >= gainByCost(p[i - 2], p[i - 1])) return false;
    }
    return !p.empty();
}

} // namespace osgPMObjects::core
