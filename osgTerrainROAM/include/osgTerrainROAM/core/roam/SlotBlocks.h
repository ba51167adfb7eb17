// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace osgTerrainROAM::core
{

/// Hands out blocks of 2^c slots, each at a multiple of its size; free blocks join with their neighbours (buddies).
/// Blocks have kSmallest to kLargest slots. Those of the largest size are a stack, for large subtrees give them back by the
/// hundred. Cost: O(1) for the largest, a set's per halving or joining for others.
/// Source: Knuth, TAOCP 1, §2.5.
class SlotBlocks
{
public:
    static constexpr std::uint32_t kSmallestClass = 2, kSmallest = 1u << kSmallestClass;
    static constexpr std::uint32_t kLargestClass = 6, kLargest = 1u << kLargestClass;

    /// First slot of a block of 2^sizeClass: of the smallest that is free and large enough, else new at the end.
    std::uint32_t take(std::uint32_t sizeClass);
    void give(std::uint32_t first, std::uint32_t sizeClass);

    std::uint32_t slotCount() const { return _slotCount; }
    std::size_t memoryBytes() const;

    /// Calls visit(first, count) for every free block.
    template<class Visit>
    void forEachFree(const Visit& visit) const
    {
        for (std::size_t sizeClass = 0; sizeClass < _free.size(); ++sizeClass)
            for (const std::uint32_t first : _free[sizeClass])
                visit(first, 1u << sizeClass);
        for (const std::uint32_t first : _freeLargest)
            visit(first, kLargest);
    }

private:
    std::array<std::set<std::uint32_t>, kLargestClass> _free; ///< first slots, by size class
    std::vector<std::uint32_t> _freeLargest;
    std::uint32_t _slotCount = 0;
};

} // namespace osgTerrainROAM::core
