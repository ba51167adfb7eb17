// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/FillHeights.h"

#include <algorithm>
#include <cmath>

namespace simulation
{

std::size_t fillHeights(FlightTrack& track)
{
    auto& fixes = track.fixes;
    std::size_t given = 0;
    const auto hasHeight = [](const TrackFix& fix) { return fix.heightM.has_value(); };
    for (std::size_t begin = 0; begin < fixes.size();)
    {
        if (hasHeight(fixes[begin]))
        {
            ++begin;
            continue;
        }
        const auto from = fixes.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto end = static_cast<std::size_t>(std::find_if(from, fixes.end(), hasHeight) - fixes.begin());
        const TrackFix* const before = begin > 0 ? &fixes[begin - 1] : nullptr;
        const TrackFix* const behind = end < fixes.size() ? &fixes[end] : nullptr;
        const bool isBetween = before && behind;
        const bool canFill = isBetween ? before->datum == behind->datum : before || behind;
        for (std::size_t i = begin; i < end && canFill; ++i, ++given)
        {
            const TrackFix& nearest = before ? *before : *behind;
            double share = 0.0;
            if (isBetween && track.hasTimes && behind->timeS > before->timeS)
                share = (fixes[i].timeS - before->timeS) / (behind->timeS - before->timeS);
            else if (isBetween)
                share = static_cast<double>(i + 1 - begin) / static_cast<double>(end + 1 - begin);
            fixes[i].heightM =
                isBetween ? std::lerp(*before->heightM, *behind->heightM, share) : *nearest.heightM;
            fixes[i].datum = nearest.datum;
            fixes[i].geoidM = fixes[i].geoidM ? fixes[i].geoidM : nearest.geoidM;
        }
        begin = end;
    }
    return given;
}

} // namespace simulation
