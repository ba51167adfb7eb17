// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

std::vector<IndexRange> joinedRanges(std::vector<std::uint32_t> slots, std::uint32_t maxGap)
{
    std::sort(slots.begin(), slots.end());
    std::vector<IndexRange> ranges;
    for (const std::uint32_t slot : slots)
    {
        if (!ranges.empty() && slot <= ranges.back().first + ranges.back().count + maxGap)
            ranges.back().count = std::max(ranges.back().count, slot - ranges.back().first + 1);
        else
            ranges.push_back({slot, 1});
    }
    return ranges;
}

} // namespace osgTerrainROAM::core
