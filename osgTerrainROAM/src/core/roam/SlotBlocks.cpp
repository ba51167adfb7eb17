// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgTerrainROAM/core/roam/SlotBlocks.h>

namespace osgTerrainROAM::core
{

std::uint32_t SlotBlocks::take(std::uint32_t sizeClass)
{
    std::uint32_t larger = sizeClass;
    while (larger < kLargestClass && _free[larger].empty())
        ++larger;
    std::uint32_t first = _slotCount;
    if (larger < kLargestClass)
        first = _free[larger].extract(_free[larger].begin()).value();
    else if (_freeLargest.empty())
        _slotCount += kLargest;
    else
    {
        first = _freeLargest.back();
        _freeLargest.pop_back();
    }
    while (larger > sizeClass)
    {
        --larger;
        _free[larger].insert(first + (1u << larger));
    }
    return first;
}

void SlotBlocks::give(std::uint32_t first, std::uint32_t sizeClass)
{
    for (; sizeClass < kLargestClass; ++sizeClass)
    {
        const std::uint32_t buddy = first ^ (1u << sizeClass);
        if (_free[sizeClass].erase(buddy) == 0)
        {
            _free[sizeClass].insert(first);
            return;
        }
        first = std::min(first, buddy);
    }
    _freeLargest.push_back(first);
}

std::size_t SlotBlocks::memoryBytes() const
{
    constexpr std::size_t kNodeBytes = 48; // of a set, with what the heap adds
    std::size_t bytes = _freeLargest.capacity() * sizeof(std::uint32_t);
    for (const auto& free : _free)
        bytes += free.size() * kNodeBytes;
    return bytes;
}

} // namespace osgTerrainROAM::core
