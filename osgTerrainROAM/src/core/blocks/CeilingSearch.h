// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

namespace osgTerrainROAM::core
{

/// Finds the least tolerance from `target` up, to one part in ten thousand, at which a choice of levels has
/// at most `most` triangles. `chooseAt(tolerance)` returns the choice, with members `tolerance` and
/// `triangles`, which do not grow with the tolerance.
template<class ChooseAt>
auto withinCeiling(double target, std::uint32_t most, const ChooseAt& chooseAt)
{
    constexpr double kNear = 1.0001, kHopeless = 1e12;
    auto best = chooseAt(target);
    double low = target;
    while (best.triangles > most && best.tolerance < kHopeless)
    {
        low = best.tolerance;
        best = chooseAt(low * 2.0);
    }
    while (best.tolerance > low * kNear)
    {
        auto between = chooseAt(std::sqrt(low * best.tolerance));
        if (between.triangles <= most)
            best = std::move(between);
        else
            low = between.tolerance;
    }
    return best;
}

} // namespace osgTerrainROAM::core
