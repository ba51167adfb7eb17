// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgPMObjects/core/selection/ScreenErrorRule.h>

namespace osgPMObjects::core
{

std::uint32_t coarsestWithin(std::span<const LevelError> errors, double tolerance,
                             const AttributeWeights& weights)
{
    const auto next =
        std::partition_point(errors.begin() + 1, errors.end(),
                             [&](const LevelError& e) { return errorOf(e, weights) <= tolerance; });
    return static_cast<std::uint32_t>(next - errors.begin()) - 1;
}

std::uint32_t heldWithin(std::span<const LevelError> errors, double tolerance, double band, HeldLevel held,
                         const AttributeWeights& weights)
{
    if (held.level < errors.size())
    {
        const bool isWithin = held.level == 0 || errorOf(errors[held.level], weights) <= tolerance;
        const bool isNeeded = held.level + 1 == errors.size() ||
                              errorOf(errors[held.level + 1], weights) > tolerance / (band * band);
        if (isWithin && isNeeded) return held.level;
    }
    return coarsestWithin(errors, tolerance / band, weights);
}

double tolerableError(double tolerancePx, double pixelsPerTangent, double depthM, double metresPerUnit)
{
    return tolerancePx * depthM / (pixelsPerTangent * metresPerUnit);
}

} // namespace osgPMObjects::core
