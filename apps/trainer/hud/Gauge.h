// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

namespace trainer
{

/// A straight scale with a pointer. Frame: pixels from its left end. Invariant: least < most.
struct GaugeScale
{
    double least = 0.0, most = 1.0; ///< values at its ends
    double tick = 0.1;              ///< between two marks
    double lengthPx = 100.0;

    /// Where the pointer stands; at the nearer end for a value outside, and at the lower for none.
    double pointerPx(double value) const
    {
        if (std::isnan(value)) return 0.0;
        return (std::clamp(value, least, most) - least) / (most - least) * lengthPx;
    }
};

/// A gauge of the head-up display: what it is called, its scale and unit.
struct GaugeKind
{
    std::string label; ///< with its unit: "IAS kt"
    double least = 0.0, most = 1.0, tick = 0.1;
    int decimals = 0; ///< of the number
};

} // namespace trainer
