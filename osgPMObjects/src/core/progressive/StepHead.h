// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include <osgPMObjects/core/progressive/Bytes.h>

namespace osgPMObjects::core
{

/// The head of a step's record (StepRecord), up to the lists of slots.
struct StepHead
{
    std::uint32_t vanished = 0, patched = 0; ///< numbers of faces
    std::uint32_t wedges = 1;                ///< removed
    bool facesMove = false;
    bool severalGo = false;
    ByteReader counts{nullptr}; ///< of patched faces by wedge, if several are removed

    /// Tells from the first byte whether a step is *plain*: one wedge goes, 1 to 14 faces are patched, at
    /// most two vanish, none moves. Most steps are, and what has to be asked for others is known for them.
    static bool isPlain(std::byte first)
    {
        const auto head = static_cast<std::uint32_t>(first);
        return head >= 1 << 2 && head < 15 << 2 && (head & 3) != 3;
    }

    /// Reads the head; `plain`: that of a plain step.
    template<bool plain>
    static StepHead read(ByteReader& in)
    {
        StepHead head;
        const std::uint32_t first = in.byte();
        head.vanished = first & 3;
        head.patched = first >> 2 & 15;
        if constexpr (plain) return head;
        head.severalGo = first & 0x40;
        head.facesMove = first & 0x80;
        if (head.vanished == 3) head.vanished = in.number();
        if (head.patched == 15) head.patched = in.number();
        if (!head.severalGo) return head;
        head.wedges = in.number();
        head.counts = in;
        for (std::uint32_t i = 0; i < head.wedges; ++i)
            in.number();
        return head;
    }

    /// Returns the number of faces that are patched for the next wedge.
    std::uint32_t nextCount() { return severalGo ? counts.number() : patched; }
};

} // namespace osgPMObjects::core
