// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace osgTerrainROAM::core
{

/// Allocates blocks of 2^c slots, each at a multiple of its size; free blocks join with their neighbours
/// (buddy system). Blocks have kSmallest to kLargest slots. Free blocks of the largest size are a stack,
/// because large subtrees return hundreds of them. Cost: O(1) for the largest size; for others that of a set
/// per halving or joining.
/// Source: Knuth, *The Art of Computer Programming*, volume 1, section 2.5 (buddy system).
class SlotBlocks
{
public:
    static constexpr std::uint32_t kSmallestClass = 2, kSmallest = 1u << kSmallestClass;
    static constexpr std::uint32_t kLargestClass = 6, kLargest = 1u << kLargestClass;

    /// Takes a block of 2^sizeClass slots from the smallest free block that is large enough, else from the
    /// end. Returns its first slot.
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
