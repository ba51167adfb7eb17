// SPDX-License-Identifier: Apache-2.0
#include "SlotCycles.h"

namespace osgPMObjects::core
{

SlotCycles::SlotCycles(std::span<const std::uint32_t> sources, std::uint32_t extent)
{
    std::vector<bool> isHole(extent, true), isSeen(extent, false);
    for (const std::uint32_t source : sources)
        isHole[source] = false;
    for (std::uint32_t hole = 0; hole < extent; ++hole)
    {
        if (!isHole[hole]) continue;
        std::uint32_t slot = hole;
        for (; slot < sources.size(); slot = sources[slot])
        {
            isSeen[slot] = true;
            throughHoles.push_back(slot);
        }
        throughHoles.push_back(slot);
    }
    for (std::uint32_t first = 0; first < sources.size(); ++first)
    {
        if (isSeen[first] || sources[first] == first) continue;
        std::vector<std::uint32_t>& cycle = others.emplace_back();
        for (std::uint32_t slot = first; !isSeen[slot]; slot = sources[slot])
        {
            isSeen[slot] = true;
            cycle.push_back(slot);
        }
    }
}

} // namespace osgPMObjects::core
