// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>

#include <osgPMObjects/core/selection/Ranges.h>

namespace osgPMObjects::core
{

bool isRanges(const Ranges& ranges)
{
    const auto& b = ranges.boundariesM;
    return ranges.steps.size() == b.size() + 1 && (b.empty() || b.front() > 0.0) &&
           std::all_of(b.begin(), b.end(), [](double boundary) { return std::isfinite(boundary); }) &&
           std::adjacent_find(b.begin(), b.end(), std::greater_equal<>()) == b.end() &&
           std::is_sorted(ranges.steps.begin(), ranges.steps.end());
}

std::uint32_t rangeAt(std::span<const double> boundariesM, double distanceM)
{
    const auto next =
        std::find_if(boundariesM.begin(), boundariesM.end(), [&](double b) { return distanceM < b; });
    return static_cast<std::uint32_t>(next - boundariesM.begin());
}

} // namespace osgPMObjects::core
