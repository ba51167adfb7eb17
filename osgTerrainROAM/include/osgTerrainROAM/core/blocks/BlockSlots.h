// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

/// Allocates runs of slots. Runs of one size take each other's place: blocks have few sizes. Cost: O(log of
/// the number of sizes).
class BlockSlots
{
public:
    /// Returns the first slot of a free run of `count` slots.
    std::uint32_t take(std::uint32_t count)
    {
        std::vector<std::uint32_t>& free = _free[count];
        if (free.empty())
        {
            free.push_back(_slotCount);
            _slotCount += count;
        }
        const std::uint32_t first = free.back();
        free.pop_back();
        return first;
    }

    void give(IndexRange run) { _free[run.count].push_back(run.first); }

    std::uint32_t slotCount() const { return _slotCount; }

private:
    std::map<std::uint32_t, std::vector<std::uint32_t>> _free; ///< first slots, by size
    std::uint32_t _slotCount = 0;
};

} // namespace osgTerrainROAM::core
