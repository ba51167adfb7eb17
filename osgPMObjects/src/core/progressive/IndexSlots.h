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

/// Writes slots of an index buffer by the rule for those that no face is in: a *hole* holds the last index of the slot before it
/// three times, a vertex that was just drawn, and index 0 if that slot is unused. So slots depend only on which are holes.
/// A view of two pointers, to be held in a local variable: what is written may be anything to the compiler, which would else
/// read members again after each byte.
template<class Index>
class SlotWriter
{
public:
    using Slot = std::array<Index, 3>;
    static constexpr Index kUnused = std::numeric_limits<Index>::max();

    /// Changes are told by so many slots: as few as make one transfer worth while.
    static constexpr std::uint32_t kPage = 64;

    /// The slot before the first and two behind the last have to be there, and unused. `isChanged`: by page.
    SlotWriter(Slot* slots, char* isChanged) : _slots(slots), _isChanged(isChanged) {}

    const Slot& operator[](std::uint32_t slot) const { return _slots[slot]; }

    /// Puts a face there. Holes behind it follow.
    void put(std::uint32_t slot, const Slot& face) const
    {
        _slots[slot] = face;
        mark(slot);
        followWith(slot, face[2]);
    }

    /// Gives a face another wedge at the corner that has `before`.
    void patch(std::uint32_t slot, Index before, Index after) const
    {
        Slot& face = _slots[slot];
        const bool isLast = face[2] == before;
        face[unsigned{face[1] == before} + 2 * unsigned{isLast}] = after;
        mark(slot);
        // One branch that is hardly ever taken, instead of two.
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

    /// Brings holes behind a slot, which was changed, in line with the rule.
    void fillHolesBehind(std::uint32_t slot) const
    {
        const Index index = indexOfHoleBehind(slot);
        for (++slot; isHole(_slots[slot]); ++slot)
        {
            _slots[slot] = {index, index, index};
            mark(slot);
        }
    }

    /// Writes a run of faces.
    template<class FaceOf>
    void fill(std::uint32_t first, std::uint32_t count, const FaceOf& faceOf) const
    {
        for (std::uint32_t i = 0; i < count; ++i)
            _slots[first + i] = faceOf(i);
        markRun(first, count);
    }

    /// The same with holes, where `isFace(i)` says so.
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
    /// Without a branch, which would be a coin's: a mispredicted one takes as long as a face.
    static Index chosen(bool isFirst, Index first, Index second)
    {
        return static_cast<Index>(second ^ ((first ^ second) & -Index{isFirst}));
    }

    /// Gives a hole behind a slot the last index of the slot, and those behind it. Most faces have no more than one behind them.
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

/// The slots of an index buffer, and which of them were written.
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

    std::vector<Slot> _slots; ///< with an unused one before the first and two behind the last
    std::vector<char> _isChanged;
};

} // namespace osgPMObjects::core
