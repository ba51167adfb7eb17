// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>

#include "SlotWriter.h"

namespace osgPMObjects::core
{

/// The slots of an index buffer, with a record of the pages that were written.
template<class Index>
class IndexSlots
{
public:
    using Writer = SlotWriter<Index>;

    /// `mostNotes`: the most that is noted between two questions whether the notes are many.
    IndexSlots(std::uint32_t count, std::size_t mostNotes)
        : _slots(count + 3, Writer::kUnused),
          _isChanged((count + 2) / Writer::kPage + 1, true),
          _notes(kManyNotes + mostNotes + 1)
    {
    }

    /// Call refreshHoles() of the writer before the slots are read.
    Writer writer() { return {_slots.data() + 1, _isChanged.data(), _notes.data()}; }

    /// Tells whether a writer's holes are to be refreshed. More notes together take no less time each.
    static bool areMany(std::size_t notes) { return notes > kManyNotes; }

    const typename Writer::Slot* data() const { return _slots.data() + 1; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(_slots.size()) - 3; }

    /// Appends the runs of pages written since the last call, and forgets them.
    void takeChanges(std::vector<SlotRange>& changes)
    {
        for (std::uint32_t page = 0; page < _isChanged.size(); ++page)
        {
            if (!_isChanged[page]) continue;
            _isChanged[page] = false;
            const std::uint32_t first = page * Writer::kPage, last = std::min(first + Writer::kPage, count());
            if (first >= last) continue;
            if (!changes.empty() && changes.back().first + changes.back().count == first)
                changes.back().count += last - first;
            else
                changes.push_back({first, last - first});
        }
    }

private:
    static constexpr std::size_t kManyNotes = 256;

    std::vector<typename Writer::Slot>
        _slots; ///< with one unused slot before the first and two behind the last
    std::vector<char> _isChanged;
    std::vector<std::uint32_t> _notes;
};

} // namespace osgPMObjects::core
