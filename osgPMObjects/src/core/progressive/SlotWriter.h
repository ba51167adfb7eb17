// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace osgPMObjects::core
{

/// Writes slots of an index buffer. A *hole* holds one index three times: the last index of the slot before
/// it, a vertex that was just drawn, or 0 if that slot is unused. So slots depend only on which of them are
/// holes. Holes are brought up to date by refreshHoles(), some hundred together: the writer only notes slots
/// whose predecessor has changed. Whether a hole follows cannot be predicted, and a mispredicted branch takes
/// as long as a face; a pass over a list needs none. The writer is a view of pointers; keep it in a local
/// variable whose address nobody takes, for the compiler would read members again after each byte that is
/// written.
template<class Index>
class SlotWriter
{
public:
    using Slot = std::array<Index, 3>;
    /// What unused slots hold: two different corners, which is no hole; the last is what a hole behind
    /// repeats.
    static constexpr Slot kUnused{std::numeric_limits<Index>::max(), 0, 0};

    /// The number of slots in a page. Changes are recorded by page, the least that is worth a transfer.
    static constexpr std::uint32_t kPage = 64;

    /// One slot before the first and two behind the last must exist and be unused. `isChanged`: by page.
    /// `notes`: room for what is noted between two calls of refreshHoles().
    SlotWriter(Slot* slots, char* isChanged, std::uint32_t* notes)
        : _slots(slots), _isChanged(isChanged), _notes(notes), _endOfNotes(notes)
    {
    }

    const Slot& operator[](std::uint32_t slot) const { return _slots[slot]; }

    void put(std::uint32_t slot, const Slot& face)
    {
        _slots[slot] = face;
        mark(slot);
        note(slot + 1);
    }

    /// Moves a face, without a note.
    void move(std::uint32_t to, std::uint32_t from) { set(to, _slots[from]); }

    /// Puts a face, without a note.
    void set(std::uint32_t slot, const Slot& face)
    {
        _slots[slot] = face;
        mark(slot);
    }

    /// Puts a face or a hole and returns what was there. Notes holes.
    Slot exchange(std::uint32_t slot, const Slot& face)
    {
        const Slot before = _slots[slot];
        set(slot, face);
        *_endOfNotes = slot;
        _endOfNotes += isHole(face);
        return before;
    }

    /// Puts a face that has the wedge `other` at two corners, or one of them and two others. The corners are
    /// written where they belong: put together in a local array, they would be read before they have left the
    /// processor's store queue.
    void put(std::uint32_t slot, Index other, std::uint32_t firstCorner, Index first,
             std::uint32_t secondCorner, Index second)
    {
        Slot& face = _slots[slot];
        face = {other, other, other};
        face[firstCorner] = first;
        face[secondCorner] = second;
        mark(slot);
        note(slot + 1);
    }

    /// Replaces the wedge `before` of a face.
    void patch(std::uint32_t slot, Index before, Index after)
    {
        Slot& face = _slots[slot];
        const bool isLast = face[2] == before;
        face[unsigned{face[1] == before} + 2 * unsigned{isLast}] = after;
        mark(slot);
        *_endOfNotes = slot + 1;
        _endOfNotes += isLast;
    }

    void makeHole(std::uint32_t slot)
    {
        const Index index = lastIndexBefore(slot);
        _slots[slot] = {index, index, index};
        mark(slot);
        note(slot + 1);
    }

    void makeUnused(std::uint32_t first, std::uint32_t count)
    {
        std::fill_n(_slots + first, count, kUnused);
        markRun(first, count);
    }

    /// Notes a slot whose predecessor has changed.
    void note(std::uint32_t slot) { *_endOfNotes++ = slot; }
    std::size_t noted() const { return static_cast<std::size_t>(_endOfNotes - _notes); }

    /// Updates the holes behind all changes, and forgets the notes. Each pass writes the holes that are
    /// listed and lists those behind them, so that a run of holes takes as many passes as it has holes.
    void refreshHoles()
    {
        Slot* const slots = _slots;
        std::uint32_t* const notes = _notes;
        std::uint32_t* end = keepHoles();
        while (end != notes)
        {
            std::uint32_t* next = notes;
            for (const std::uint32_t* at = notes; at != end; ++at)
            {
                const std::uint32_t slot = *at;
                const Index index = lastIndexBefore(slot);
                slots[slot] = {index, index, index};
                mark(slot);
                *next = slot + 1;
                next += isHole(slots[slot + 1]);
            }
            end = next;
        }
        _endOfNotes = notes;
    }

    /// Writes a run of faces, without a note.
    template<class FaceOf>
    void fill(std::uint32_t first, std::uint32_t count, const FaceOf& faceOf)
    {
        for (std::uint32_t i = 0; i < count; ++i)
            _slots[first + i] = faceOf(i);
        markRun(first, count);
    }

    /// Writes a run of slots: a face where `isFace(i)`, else a hole. Notes the first.
    template<class IsFace, class FaceOf>
    void fill(std::uint32_t first, std::uint32_t count, const IsFace& isFace, const FaceOf& faceOf)
    {
        Index last = lastIndexBefore(first);
        for (std::uint32_t i = 0; i < count; ++i)
        {
            const Slot face = faceOf(i);
            const bool is = isFace(i);
            const Index before = last;
            last = chosen(is, face[2], before);
            _slots[first + i] = {chosen(is, face[0], before), chosen(is, face[1], before), last};
        }
        markRun(first, count);
        note(first);
    }

    static bool isHole(const Slot& slot) { return slot[0] == slot[1]; }

private:
    /// Selects without a branch: the choice is random, and a mispredicted branch takes as long as a face.
    static Index chosen(bool isFirst, Index first, Index second)
    {
        return static_cast<Index>(second ^ ((first ^ second) & -Index{isFirst}));
    }

    /// Keeps the notes of holes and returns their end.
    std::uint32_t* keepHoles() const
    {
        std::uint32_t* kept = _notes;
        for (const std::uint32_t* at = _notes; at != _endOfNotes; ++at)
        {
            const std::uint32_t slot = *at;
            *kept = slot;
            kept += isHole(_slots[slot]);
        }
        return kept;
    }

    Index lastIndexBefore(std::uint32_t slot) const
    {
        return _slots[static_cast<std::ptrdiff_t>(slot) - 1][2];
    }

    void mark(std::uint32_t slot) const { _isChanged[slot / kPage] = true; }

    void markRun(std::uint32_t first, std::uint32_t count) const
    {
        if (count > 0)
            std::fill(_isChanged + first / kPage, _isChanged + (first + count - 1) / kPage + 1, char{true});
    }

    Slot* _slots;
    char* _isChanged;
    std::uint32_t *_notes, *_endOfNotes;
};

} // namespace osgPMObjects::core
