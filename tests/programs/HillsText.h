// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

/// Returns an Arc/Info ASCII grid in degrees: a plain with hills in the north, 7 km wide.
inline std::string hillsText()
{
    constexpr int kSide = 91;
    std::string text = "ncols 91\nnrows 91\nxllcorner 1.455\nyllcorner 42.465\ncellsize 0.001\n";
    for (int row = 0; row < kSide; ++row)
    {
        for (int column = 0; column < kSide; ++column)
        {
            const double rise = std::max(0, 40 - row);
            text += std::to_string(400.0 + 6.0 * rise + 2.5 * rise * std::sin(0.2 * column)) + ' ';
        }
        text += '\n';
    }
    return text;
}
