// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgPMObjects/core/selection/DrawableRows.h>
#include <osgPMObjects/core/selection/ScreenErrorRule.h>

namespace osgPMObjects::core
{

namespace
{

/// Returns the most steps, at most `most`, whose estimates are within the tolerance; the distance counts only
/// if none is measured.
std::uint32_t mostByEstimates(const LevelTable& table, double tolerance, const AttributeWeights& weights,
                              std::uint32_t most)
{
    const bool isMeasured = !table.measured.isEmpty();
    if (isMeasured && weights == AttributeWeights{}) return most;
    const auto isWithin = [&](LevelError error)
    {
        if (isMeasured) error.distance = 0.0f;
        return errorOf(error, weights) <= tolerance;
    };
    const auto begin = table.errors.begin() + 1;
    return static_cast<std::uint32_t>(std::partition_point(begin, begin + most, isWithin) - begin);
}

} // namespace

std::uint32_t coarsestWithin(const LevelTable& table, double tolerance, const ErrorMeasure& measure,
                             const AllowedLevels& allowed)
{
    const auto last = static_cast<std::uint32_t>(table.errors.size()) - 1;
    std::uint32_t steps =
        mostByEstimates(table, tolerance, measure.weights, std::min(allowed.mostSteps, last));
    if (!table.measured.isEmpty()) steps = table.measured.coarsestWithin(tolerance, measure.kind, steps);
    if (allowed.drawable.empty()) return steps;
    std::uint32_t row = drawableRowOf(allowed.drawable, steps);
    while (row > 0 &&
           errorOf(table.errorAfter(allowed.drawable[row], measure.kind), measure.weights) > tolerance)
        --row;
    return allowed.drawable[row];
}

std::uint32_t heldWithin(const LevelTable& table, double tolerance, double band, HeldLevel held,
                         const ErrorMeasure& measure, const AllowedLevels& allowed)
{
    if (held.level >= table.errors.size()) return coarsestWithin(table, tolerance, measure, allowed);
    const bool isWithin =
        held.level == 0 || errorOf(table.errorAfter(held.level, measure.kind), measure.weights) <= tolerance;
    if (isWithin && coarsestWithin(table, tolerance / (band * band), measure, allowed) <= held.level)
        return held.level;
    return coarsestWithin(table, tolerance / band, measure, allowed);
}

double tolerableError(double tolerancePx, double pixelsPerTangent, double depthM, double metresPerUnit)
{
    return tolerancePx * depthM / (pixelsPerTangent * metresPerUnit);
}

} // namespace osgPMObjects::core
