// SPDX-License-Identifier: Apache-2.0
#include "LevelPlayer.h"

#include <algorithm>
#include <type_traits>

#include "IndexSlots.h"
#include "RearrangementReader.h"
#include "StepHead.h"
#include "StepRecord.h"

namespace osgPMObjects::core
{

namespace
{

constexpr auto kVanishedFaces = []
{
    std::array<VanishedFace, VanishedFace::kPlain> faces{};
    for (std::uint32_t code = 0; code < faces.size(); ++code)
        faces[code] = VanishedFace::ofCode(code);
    return faces;
}();

/// Plays the records of steps (StepRecord) on indices of one width.
template<class Index>
class IndexPlayer : public ProgressiveLevel::Player
{
public:
    explicit IndexPlayer(const ProgressiveMesh& progressive)
        : Player(progressive),
          _widths(progressive),
          _parents(progressive.parents.begin(), progressive.parents.end()),
          _at(progressive.records.data() + progressive.records.size() - kRecordPadding),
          _slots(progressive.slotCount,
                 progressive.mostSlotsOfStep + RearrangementReader<Index>::mostNotes(progressive)),
          _slotsOfStep(progressive.mostSlotsOfStep),
          _fromOfPatched(progressive.mostSlotsOfStep),
          _rearrangements(progressive.mostRearrangements),
          _rearranger(progressive, _extents)
    {
        putBase();
    }

    void moveTo(std::uint32_t steps) override
    {
        Cursor cursor{_slots.writer(), _at, _wedges, _faces};
        _statistics.steps += std::max(steps, _steps) - std::min(steps, _steps);
        while (_steps < steps)
            if (down<true>(cursor, steps); _steps < steps) cursor = specialDown(cursor, steps);
        while (_steps > steps)
            if (up<true>(cursor, steps); _steps > steps) cursor = specialUp(cursor, steps);
        cursor.slots.refreshHoles();
        _at = cursor.at;
        _wedges = cursor.wedges;
        _faces = cursor.faces;
        _statistics.facesPatched += cursor.patched;
        _statistics.facesVanished += cursor.vanished;
    }

    void takeChanges(std::vector<SlotRange>& changes) override { _slots.takeChanges(changes); }

    std::span<const std::uint16_t> narrowIndices() const override { return indicesAs<std::uint16_t>(); }
    std::span<const std::uint32_t> wideIndices() const override { return indicesAs<std::uint32_t>(); }

private:
    using Slots = SlotWriter<Index>;

    /// Where a play is. A local variable is one: its members stay in registers while bytes are written.
    struct Cursor
    {
        Slots slots;
        const std::byte* at; ///< end of the last record that was played
        std::uint32_t wedges, faces;
        std::uint64_t patched = 0, vanished = 0; ///< faces so far

        void count(const StepHead& head)
        {
            patched += head.patched;
            vanished += head.vanished;
        }
    };

    template<class Wanted>
    std::span<const Wanted> indicesAs() const
    {
        if constexpr (std::is_same_v<Wanted, Index>)
            return {_slots.data()->data(), std::size_t{3} * _slots.count()};
        else
            return {};
    }

    void putBase()
    {
        Slots slots = _slots.writer();
        auto next = _progressive.base.begin();
        for (const FaceBlock& block : _progressive.blocks)
        {
            slots.fill(
                block.firstSlot, block.extent, [&](std::uint32_t i) { return !repeatsCorner(next[i]); },
                [&](std::uint32_t i) -> typename Slots::Slot {
                    return {static_cast<Index>(next[i][0]), static_cast<Index>(next[i][1]),
                            static_cast<Index>(next[i][2])};
                });
            next += block.extent;
        }
        _faces =
            static_cast<std::uint32_t>(std::count_if(_progressive.base.begin(), _progressive.base.end(),
                                                     [](const Triangle& t) { return !repeatsCorner(t); }));
    }

    /// Plays steps as long as they are plain, or as long as they are not.
    template<bool plain>
    void down(Cursor& cursor, std::uint32_t steps)
    {
        for (; _steps < steps && StepHead::isPlain(*cursor.at) == plain; ++_steps)
        {
            ecol<plain>(cursor);
            if (_slots.areMany(cursor.slots.noted())) [[unlikely]]
                cursor.slots = refreshed(cursor.slots);
        }
    }

    template<bool plain>
    void up(Cursor& cursor, std::uint32_t steps)
    {
        for (; _steps > steps; --_steps)
        {
            const std::byte* const begin = beginOfRecordBefore(cursor.at);
            if (StepHead::isPlain(*begin) != plain) break;
            vsplit<plain>(cursor, begin);
            if (_slots.areMany(cursor.slots.noted())) [[unlikely]]
                cursor.slots = refreshed(cursor.slots);
        }
    }

    /// Steps that are not plain, apart, so that they take no registers from the loops of plain ones.
    [[gnu::noinline]] Cursor specialDown(Cursor cursor, std::uint32_t steps)
    {
        down<false>(cursor, steps);
        return cursor;
    }
    [[gnu::noinline]] Cursor specialUp(Cursor cursor, std::uint32_t steps)
    {
        up<false>(cursor, steps);
        return cursor;
    }
    [[gnu::noinline]] static Slots refreshed(Slots slots)
    {
        slots.refreshHoles();
        return slots;
    }

    template<bool plain>
    void ecol(Cursor& cursor)
    {
        Slots slots = cursor.slots;
        ByteReader in(cursor.at);
        const StepHead head = StepHead::read<plain>(in);
        SlotLists lists(in, _widths.slot);
        cursor.wedges -= head.wedges;
        visitPatched<plain>(head, lists, cursor.wedges,
                            [&slots](std::uint32_t slot, Index from, Index to)
                            { slots.patch(slot, from, to); });
        lists.visit(head.vanished, [&slots](std::uint32_t slot) { slots.makeHole(slot); });
        skipCodes(in, head.vanished);
        if (!plain && head.facesMove) slots = forthRearrangements(in, slots);
        cursor.at = skipLength(in.at(), plain ? 0 : static_cast<std::size_t>(in.at() - cursor.at));
        cursor.faces -= head.vanished;
        cursor.count(head);
        cursor.slots = slots;
    }

    template<bool plain>
    void vsplit(Cursor& cursor, const std::byte* begin)
    {
        Slots slots = cursor.slots;
        std::uint32_t* const slotsOfStep = _slotsOfStep.data();
        Index* const fromOfPatched = _fromOfPatched.data();
        ByteReader in(begin);
        const StepHead head = StepHead::read<plain>(in);
        if (!plain && head.facesMove) slots = backRearrangements(in, head, slots);
        SlotLists lists(in, _widths.slot);
        std::uint32_t read = 0;
        visitPatched<plain>(head, lists, cursor.wedges,
                            [&](std::uint32_t slot, Index from, Index to)
                            {
                                slots.patch(slot, to, from);
                                slotsOfStep[read] = slot;
                                fromOfPatched[read++] = from;
                            });
        const std::uint32_t patched = read;
        lists.visit(head.vanished, [&](std::uint32_t slot) { slotsOfStep[read++] = slot; });
        for (std::uint32_t i = patched; i < read; ++i)
            putVanished(slotsOfStep[i], in, slots);
        cursor.at = begin;
        cursor.wedges += head.wedges;
        cursor.faces += head.vanished;
        cursor.count(head);
        cursor.slots = slots;
    }

    /// Calls `visit(slot, from, to)` for each patched face of a step, after which `wedges` wedges are left.
    template<bool plain, class Lists, class Visit>
    void visitPatched(StepHead head, Lists& lists, std::uint32_t wedges, const Visit& visit) const
    {
        for (std::uint32_t gone = 0; gone < head.wedges; ++gone)
        {
            const Index from = static_cast<Index>(wedges + head.wedges - 1 - gone), to = _parents[from];
            const auto visitSlot = [&visit, from, to](std::uint32_t slot) { visit(slot, from, to); };
            if constexpr (plain)
                lists.visitSome(head.patched, visitSlot);
            else
                lists.visit(head.nextCount(), visitSlot);
        }
    }

    void skipCodes(ByteReader& in, std::uint32_t vanished) const
    {
        for (; vanished > 0; --vanished)
            if (in.byte() == VanishedFace::kPlain) [[unlikely]]
                in.skip(3 * _widths.wedge.bytes);
    }

    Slots forthRearrangements(ByteReader& in, Slots slots)
    {
        for (std::uint32_t count = in.number(); count > 0; --count)
        {
            if (_slots.areMany(slots.noted())) slots = refreshed(slots);
            _statistics.facesMoved += _rearranger.forth(in, slots);
        }
        return slots;
    }

    /// Undoes the rearrangements. Their bytes follow the lists of slots, which refer to the slots before
    /// them.
    Slots backRearrangements(ByteReader in, const StepHead& head, Slots slots)
    {
        SlotLists lists(in, _widths.slot);
        visitPatched<false>(head, lists, 0, [](std::uint32_t, Index, Index) {});
        lists.visit(head.vanished, [](std::uint32_t) {});
        skipCodes(in, head.vanished);
        const std::uint32_t count = in.number();
        for (std::uint32_t i = 0; i < count; ++i)
        {
            _rearrangements[i] = in.at();
            if (i + 1 < count) _rearranger.skip(in);
        }
        for (std::uint32_t i = count; i-- > 0;)
        {
            ByteReader rearrangement(_rearrangements[i]);
            if (_slots.areMany(slots.noted())) slots = refreshed(slots);
            _statistics.facesMoved += _rearranger.back(rearrangement, slots);
        }
        return slots;
    }

    /// Puts a vanished face back, once the patched faces of its step have their corners again.
    void putVanished(std::uint32_t slot, ByteReader& codes, Slots& slots) const
    {
        const std::uint32_t code = codes.byte();
        if (code == VanishedFace::kPlain) [[unlikely]]
        {
            const auto a = static_cast<Index>(codes.fixed(_widths.wedge));
            const auto b = static_cast<Index>(codes.fixed(_widths.wedge));
            const auto c = static_cast<Index>(codes.fixed(_widths.wedge));
            slots.put(slot, {a, b, c});
            return;
        }
        const VanishedFace face = kVanishedFaces[code];
        const Index from = _fromOfPatched[face.patched];
        const Index third = slots[_slotsOfStep[face.patched]][face.corner];
        slots.put(slot, _parents[from], face.third, third, face.from, from);
    }

    RecordWidths _widths;
    std::vector<Index> _parents;
    const std::byte* _at; ///< Cursor::at
    IndexSlots<Index> _slots;
    std::vector<std::uint32_t> _slotsOfStep;
    std::vector<Index> _fromOfPatched;
    std::vector<const std::byte*> _rearrangements;
    RearrangementReader<Index> _rearranger;
};

} // namespace

std::unique_ptr<ProgressiveLevel::Player> makeNarrowPlayer(const ProgressiveMesh& progressive)
{
    return std::make_unique<IndexPlayer<std::uint16_t>>(progressive);
}

std::unique_ptr<ProgressiveLevel::Player> makeWidePlayer(const ProgressiveMesh& progressive)
{
    return std::make_unique<IndexPlayer<std::uint32_t>>(progressive);
}

} // namespace osgPMObjects::core
