// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <osgPMObjects/core/selection/ContinuousRule.h>

namespace osgPMObjects::core
{

double referenceDistanceM(double pixelsPerTangent, double area, std::uint32_t faces, double trianglePx)
{
    return faces == 0 ? 0.0 : pixelsPerTangent * std::sqrt(2.0 * area / faces) / trianglePx;
}

Removal removalAt(double referenceM, double distanceM, std::uint32_t positions, std::uint32_t mostSteps)
{
    if (!(distanceM > referenceM) || positions < 3) return {};
    // The division comes last, so that half a position is exactly half; T is below 2³², as positions are.
    const double squares = (distanceM - referenceM) * (distanceM + referenceM);
    const double wanted = (positions - 2.0) * squares / (distanceM * distanceM);
    const auto removed = static_cast<std::uint32_t>(std::floor(wanted + 0.5));
    return removed > mostSteps ? Removal{mostSteps, true} : Removal{removed, false};
}

Removal heldRemovalAt(double referenceM, double distanceM, std::uint32_t positions, std::uint32_t mostSteps,
                      double band, HeldLevel held)
{
    const Removal most = removalAt(referenceM, distanceM, positions, mostSteps);
    if (band == 1.0) return most;
    if (held.isHeld() && held.level <= most.steps &&
        held.level >= removalAt(referenceM, distanceM / (band * band), positions, mostSteps).steps)
        return {held.level, most.isClamped && held.level == mostSteps};
    return removalAt(referenceM, distanceM / band, positions, mostSteps);
}

} // namespace osgPMObjects::core
