// SPDX-License-Identifier: Apache-2.0
#include "CyclesRecord.h"

#include <osgPMObjects/core/progressive/Bytes.h>

#include "SlotCycles.h"

namespace osgPMObjects::core
{

void appendCycleLists(std::vector<std::byte>& bytes, const CycleSlots& change)
{
    const SlotCycles cycles(change.sources, change.extent);
    const auto append = [&](const std::vector<std::uint32_t>& cycle)
    {
        appendNumber(bytes, cycle.size());
        for (const std::uint32_t slot : cycle)
            appendFixed(bytes, slot, widthFor(change.extent));
    };
    append(cycles.throughHoles);
    appendNumber(bytes, cycles.others.size());
    for (const std::vector<std::uint32_t>& cycle : cycles.others)
        append(cycle);
}

void appendCycleSlots(std::vector<std::byte>& bytes, const CycleSlots& change)
{
    appendNumber(bytes, 0);
    appendNumber(bytes, change.block);
    appendNumber(bytes, change.extent);
    appendNumber(bytes, change.extent - change.sources.size());
    appendCycleLists(bytes, change);
}

void appendLengthOfRecord(std::vector<std::byte>& bytes, std::size_t length)
{
    if (length <= 0xff) return appendFixed(bytes, length, 1);
    appendFixed(bytes, length, 4);
    appendFixed(bytes, 0, 1);
}

} // namespace osgPMObjects::core
