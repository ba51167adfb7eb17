// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace osgPMObjects::core
{

/// Fills empty texels with the mean of the nearest filled ones: means of four go up a pyramid of halved
/// images, and down again into empty texels. `isShown`: by texel, filled; the size is a power of two.
/// Memory: a third more than the image. Cost: linear.
/// Source: Gortler, Grzeszczuk, Szeliski and Cohen, *The Lumigraph* (1996), section 3.4 (pull-push). Differs:
/// no weights, since filled texels must not change.
template<std::size_t Channels>
void fillTexels(std::vector<std::array<std::uint8_t, Channels>>& texels, std::vector<std::uint8_t> isShown,
                std::size_t size)
{
    if (size == 1) return;
    const std::size_t half = size / 2;
    std::vector<std::array<std::uint8_t, Channels>> means(half * half);
    std::vector<std::uint8_t> isMean(half * half, 0);
    for (std::size_t y = 0; y < half; ++y)
        for (std::size_t x = 0; x < half; ++x)
        {
            std::array<unsigned, Channels> sum{};
            unsigned count = 0;
            for (const std::size_t i : {2 * y * size + 2 * x, 2 * y * size + 2 * x + 1,
                                        (2 * y + 1) * size + 2 * x, (2 * y + 1) * size + 2 * x + 1})
            {
                if (!isShown[i]) continue;
                ++count;
                for (std::size_t c = 0; c < Channels; ++c)
                    sum[c] += texels[i][c];
            }
            if (count == 0) continue;
            isMean[y * half + x] = 1;
            for (std::size_t c = 0; c < Channels; ++c)
                means[y * half + x][c] = static_cast<std::uint8_t>((sum[c] + count / 2) / count);
        }
    fillTexels(means, std::move(isMean), half);
    for (std::size_t y = 0; y < size; ++y)
        for (std::size_t x = 0; x < size; ++x)
            if (!isShown[y * size + x]) texels[y * size + x] = means[y / 2 * half + x / 2];
}

} // namespace osgPMObjects::core
