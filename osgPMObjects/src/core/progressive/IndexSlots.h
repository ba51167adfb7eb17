// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>

namespace osgPMObjects::core
{

/// The slots of an index buffer, and the rule for those that no face is in: a *hole* holds the last index of the slot before it
/// three times, a vertex that was just drawn, and index 0 if that slot is unused. So slots depend only on which are holes.
template<class Index>
class IndexSlots
{
public:
    using Slot = std::array<Index, 3>;
    static constexpr Index kUnused = std::numeric_limits<Index>::max();

    explicit IndexSlots(std::uint32_t count)
        : _slots(count + 2, Slot{kUnused, kUnused, kUnused}), _isChanged(count / kPage + 1, true)
    {
    }

    const Slot& operator[](std::uint32_t slot) const { return _slots[slot + 1]; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(_slots.size()) - 2; }
    const Slot* data() const { return _slots.data() + 1; }

    /// Puts a face there. Holes behind it follow.
    void put(std::uint32_t slot, const Slot& face)
    {
        at(slot) = face;
        mark(slot);
        if (isHole(at(slot + 1))) fillHolesBehind(slot);
    }

    /// Gives a face another wedge at the corner that has `before`.
    void patch(std::uint32_t slot, Index before, Index after)
    {
        Slot& face = at(slot);
        face[0] = face[0] == before ? after : face[0];
        face[1] = face[1] == before ? after : face[1];
        const bool isLast = face[2] == before;
        face[2] = isLast ? after : face[2];
        mark(slot);
        if (isLast & isHole(at(slot + 1))) [[unlikely]]
            fillHolesBehind(slot);
    }

    void makeHole(std::uint32_t slot)
    {
        const Index index = indexOfHoleBehind(_slots[slot]);
        at(slot) = {index, index, index};
        mark(slot);
        if (isHole(at(slot + 1))) fillHolesBehind(slot);
    }

    void makeUnused(std::uint32_t slot)
    {
        at(slot) = {kUnused, kUnused, kUnused};
        mark(slot);
    }

    /// Brings holes behind a slot, which was changed, in line with the rule.
    void fillHolesBehind(std::uint32_t slot)
    {
        const Index index = indexOfHoleBehind(at(slot));
        for (++slot; isHole(at(slot)); ++slot)
        {
            at(slot) = {index, index, index};
            mark(slot);
        }
    }

    /// Writes a run of slots that says by `isFace(i)` and `face(i)` what is in them.
    template<class IsFace, class FaceOf>
    void fill(std::uint32_t first, std::uint32_t count, const IsFace& isFace, const FaceOf& faceOf)
    {
        for (std::uint32_t i = 0; i < count; ++i)
        {
            const Index index = indexOfHoleBehind(_slots[first + i]);
            at(first + i) = isFace(i) ? faceOf(i) : Slot{index, index, index};
        }
        markRun(first, count);
    }

    static bool isHole(const Slot& slot) { return (slot[0] == slot[1]) & (slot[0] != kUnused); }

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

    void markRun(std::uint32_t first, std::uint32_t count)
    {
        if (count > 0)
            std::fill(_isChanged.begin() + first / kPage,
                      _isChanged.begin() + (first + count - 1) / kPage + 1, char{true});
    }

private:
    /// Changes are told by so many slots: as few as make one transfer worth while.
    static constexpr std::uint32_t kPage = 64;

    Slot& at(std::uint32_t slot) { return _slots[slot + 1]; }
    void mark(std::uint32_t slot) { _isChanged[slot / kPage] = true; }
    static Index indexOfHoleBehind(const Slot& slot) { return slot[0] == kUnused ? Index{0} : slot[2]; }

    std::vector<Slot> _slots; ///< with an unused one before the first and behind the last
    std::vector<char> _isChanged;
};

} // namespace osgPMObjects::core
