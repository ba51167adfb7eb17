// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgPMObjects::core
{

/// A new order of the faces of a block, as a table.
struct CycleSlots
{
    std::uint32_t block = 0, extent = 0; ///< extent: slots before the change, holes included
    /// By slot after the change: the slot of its face before, each less than `extent` and once.
    std::vector<std::uint32_t> sources;
};

/// Appends the cycles of a change (SlotCycles): the length and the slots of the one through the holes, the
/// number of other cycles and the same of each. Slots count from the first of the block on, in as many bytes
/// as the extent needs.
void appendCycleLists(std::vector<std::byte>& bytes, const CycleSlots& change);

/// Appends a change as records have it: 0, the block, its extent, by how much that shrinks, and the cycles.
void appendCycleSlots(std::vector<std::byte>& bytes, const CycleSlots& change);

/// Appends the length of a record, which stands at its end.
void appendLengthOfRecord(std::vector<std::byte>& bytes, std::size_t length);

} // namespace osgPMObjects::core
