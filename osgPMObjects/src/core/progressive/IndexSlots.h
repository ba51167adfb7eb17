// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>

namespace osgPMObjects::core
{

/// Writes slots of an index buffer and keeps holes valid. A *hole* holds one index three times: the last index of the slot
/// before it, a vertex that was just drawn, or 0 if that slot is unused. So slots depend only on which of them are holes.
/// The writer is a view of two pointers; keep it in a local variable, for the compiler would read members again after each
/// byte that is written.
template<class Index>
class SlotWriter
{
public:
    using Slot = std::array<Index, 3>;
    static constexpr Index kUnused = std::numeric_limits<Index>::max();

    /// The number of slots in a page. Changes are recorded by page, the least that is worth a transfer.
    static constexpr std::uint32_t kPage = 64;

    /// One slot before the first and two behind the last must exist and be unused. `isChanged`: by page.
    SlotWriter(Slot* slots, char* isChanged) : _slots(slots), _isChanged(isChanged) {}

    const Slot& operator[](std::uint32_t slot) const { return _slots[slot]; }

    /// Writes a face and updates the holes behind it.
    void put(std::uint32_t slot, const Slot& face) const
    {
        _slots[slot] = face;
        mark(slot);
        followWith(slot, face[2]);
    }

    /// Replaces the wedge `before` of a face.
    void patch(std::uint32_t slot, Index before, Index after) const
    {
        Slot& face = _slots[slot];
        const bool isLast = face[2] == before;
        face[unsigned{face[1] == before} + 2 * unsigned{isLast}] = after;
        mark(slot);
        // One branch that is rarely taken, instead of two.
        if ((unsigned{isLast} & unsigned{isHole(_slots[slot + 1])}) != 0) [[unlikely]]
            fillHolesBehind(slot);
    }

    void makeHole(std::uint32_t slot) const
    {
        const Index index = indexOfHoleBehind(static_cast<std::ptrdiff_t>(slot) - 1);
        _slots[slot] = {index, index, index};
        mark(slot);
        followWith(slot, index);
    }

    void makeUnused(std::uint32_t slot) const
    {
        _slots[slot] = {kUnused, kUnused, kUnused};
        mark(slot);
    }

    /// Updates the holes behind a slot that was changed.
    void fillHolesBehind(std::uint32_t slot) const
    {
        const Index index = indexOfHoleBehind(slot);
        for (++slot; isHole(_slots[slot]); ++slot)
        {
            _slots[slot] = {index, index, index};
            mark(slot);
        }
    }

    /// Writes a run of faces, without updating holes.
    template<class FaceOf>
    void fill(std::uint32_t first, std::uint32_t count, const FaceOf& faceOf) const
    {
        for (std::uint32_t i = 0; i < count; ++i)
            _slots[first + i] = faceOf(i);
        markRun(first, count);
    }

    /// Writes a run of slots: a face where `isFace(i)`, else a hole.
    template<class IsFace, class FaceOf>
    void fill(std::uint32_t first, std::uint32_t count, const IsFace& isFace, const FaceOf& faceOf) const
    {
        for (std::uint32_t i = 0; i < count; ++i)
        {
            const Index index = indexOfHoleBehind(static_cast<std::ptrdiff_t>(first + i) - 1);
            const Slot face = faceOf(i);
            const bool is = isFace(i);
            _slots[first + i] = {chosen(is, face[0], index), chosen(is, face[1], index),
                                 chosen(is, face[2], index)};
        }
        markRun(first, count);
    }

    static bool isHole(const Slot& slot)
    {
        return (unsigned{slot[0] == slot[1]} & unsigned{slot[0] != kUnused}) != 0;
    }

private:
    /// Selects without a branch: the choice is random, and a mispredicted branch takes as long as a face.
    static Index chosen(bool isFirst, Index first, Index second)
    {
        return static_cast<Index>(second ^ ((first ^ second) & -Index{isFirst}));
    }

    /// Updates a hole behind a slot, and the holes behind that one. Most faces have at most one hole behind them.
    void followWith(std::uint32_t slot, Index index) const
    {
        Slot& next = _slots[slot + 1];
        const bool follows = isHole(next);
        for (Index& corner : next)
            corner = chosen(follows, index, corner);
        _isChanged[(slot + 1) / kPage] |= char{follows};
        if ((unsigned{follows} & unsigned{isHole(_slots[slot + 2])}) != 0) [[unlikely]]
            fillHolesBehind(slot + 1);
    }

    void mark(std::uint32_t slot) const { _isChanged[slot / kPage] = true; }

    void markRun(std::uint32_t first, std::uint32_t count) const
    {
        if (count > 0)
            std::fill(_isChanged + first / kPage, _isChanged + (first + count - 1) / kPage + 1, char{true});
    }

    Index indexOfHoleBehind(std::ptrdiff_t slot) const
    {
        return _slots[slot][0] == kUnused ? Index{0} : _slots[slot][2];
    }

    Slot* _slots;
    char* _isChanged;
};

/// The slots of an index buffer, with a record of the pages that were written.
template<class Index>
class IndexSlots
{
public:
    using Slot = typename SlotWriter<Index>::Slot;

    explicit IndexSlots(std::uint32_t count)
        : _slots(count + 3,
                 Slot{SlotWriter<Index>::kUnused, SlotWriter<Index>::kUnused, SlotWriter<Index>::kUnused}),
          _isChanged((count + 2) / kPage + 1, true)
    {
    }

    SlotWriter<Index> writer() { return {_slots.data() + 1, _isChanged.data()}; }
    const Slot* data() const { return _slots.data() + 1; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(_slots.size()) - 3; }

    void takeChanges(std::vector<SlotRange>& changes)
    {
        for (std::uint32_t page = 0; page < _isChanged.size(); ++page)
        {
            if (!_isChanged[page]) continue;
            _isChanged[page] = false;
            const std::uint32_t first = page * kPage, last = std::min(first + kPage, count());
            if (first >= last) continue;
            if (!changes.empty() && changes.back().first + changes.back().count == first)
                changes.back().count += last - first;
            else
                changes.push_back({first, last - first});
        }
    }

private:
    static constexpr std::uint32_t kPage = SlotWriter<Index>::kPage;

    std::vector<Slot> _slots; ///< with one unused slot before the first and two behind the last
    std::vector<char> _isChanged;
};

} // namespace osgPMObjects::core
