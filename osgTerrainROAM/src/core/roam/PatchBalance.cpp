// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>

#include <osgTerrainROAM/core/roam/PatchBalance.h>

namespace osgTerrainROAM::core
{

namespace
{

constexpr int kFramesInTurn = 4; ///< the first of a turn adapts a mesh that has not followed the eye
constexpr double kClearlyLess = 0.97;

double median(std::vector<double>& values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

PatchBalance measurePatchBalance(std::span<const int> exponents, int frames,
                                 const std::function<double(int exponent)>& frameMs)
{
    assert(!exponents.empty() && frames > 0);
    std::vector<std::vector<double>> times(exponents.size());
    for (int done = 0; done < frames; done += kFramesInTurn)
        for (std::size_t i = 0; i < exponents.size(); ++i)
        {
            frameMs(exponents[i]);
            for (int frame = 0; frame < kFramesInTurn; ++frame)
                times[i].push_back(frameMs(exponents[i]));
        }
    PatchBalance balance{exponents[0], {}};
    double least = 0.0;
    for (std::size_t i = 0; i < exponents.size(); ++i)
    {
        balance.rows.push_back({exponents[i], median(times[i])});
        const double ms = balance.rows.back().medianMs;
        if (i > 0 && ms >= kClearlyLess * least) continue;
        least = ms;
        balance.exponent = exponents[i];
    }
    return balance;
}

} // namespace osgTerrainROAM::core
