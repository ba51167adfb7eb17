// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace osgPMObjects::core
{

/// The cycles of a new order of the faces in a block: *tswap*. In a cycle the face in each slot moves to the
/// slot before it, the face in the first slot to the last one. Slots that keep their face are in no cycle. A
/// hole counts as the face that has vanished from it: one cycle takes all of them to the end of the block.
/// Played backwards, from the same slots, a cycle is its own inverse; it needs no other memory.
/// Source: *Cache-friendly view-independent progressive meshes* (Graphicon 2003), section 5: the order is
/// found as a table and becomes cycles at the end.
struct SlotCycles
{
    /// `sources`: by slot after the change: the slot of its face before, each less than `extent` and once;
    /// the other slots below `extent` are holes before and unused afterwards.
    SlotCycles(std::span<const std::uint32_t> sources, std::uint32_t extent);

    /// Holes in ascending order, each followed by the slots from where faces come, up to one that is unused
    /// afterwards.
    std::vector<std::uint32_t> throughHoles;
    std::vector<std::vector<std::uint32_t>> others; ///< of two slots or more
};

} // namespace osgPMObjects::core
