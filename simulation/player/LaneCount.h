// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace simulation
{

/// Returns the lane so many lanes to the left of another, seen towards greater s: lane ids rise to the left
/// and have no 0.
/// Source: ASAM OpenSCENARIO XML 1.3, RelativeTargetLane (which counts to the left of the entity).
constexpr int lanesBeside(int lane, int lanes)
{
    const int sum = lane + lanes;
    if (lane < 0 && sum >= 0) return sum + 1;
    if (lane > 0 && sum <= 0) return sum - 1;
    return sum;
}

} // namespace simulation
