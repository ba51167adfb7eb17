// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace scenery::models
{

/// An image of red, green, blue and alpha bytes (display values), bottom row first.
/// Invariant: rgba has 4 × widthPx × heightPx bytes; both sizes are powers of two.
struct Picture
{
    int widthPx = 0, heightPx = 0;
    std::vector<std::uint8_t> rgba;

    std::uint8_t* at(int x, int y) { return &rgba[4 * (static_cast<std::size_t>(y) * widthPx + x)]; }
    const std::uint8_t* at(int x, int y) const
    {
        return &rgba[4 * (static_cast<std::size_t>(y) * widthPx + x)];
    }
    bool operator==(const Picture&) const = default;
};

} // namespace scenery::models
