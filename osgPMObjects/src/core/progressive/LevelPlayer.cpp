// SPDX-License-Identifier: Apache-2.0
#include "LevelPlayer.h"

#include <algorithm>
#include <type_traits>

#include "IndexSlots.h"
#include "RearrangementReader.h"
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
          _slots(progressive.slotCount),
          _slotsOfStep(progressive.mostSlotsOfStep),
          _fromOfPatched(progressive.mostSlotsOfStep),
          _rearrangements(progressive.mostRearrangements),
          _rearranger(progressive, _extents)
    {
        putBase();
    }

    void moveTo(std::uint32_t steps) override
    {
        while (_steps < steps)
            ecol();
        while (_steps > steps)
            vsplit();
    }

    void takeChanges(std::vector<SlotRange>& changes) override { _slots.takeChanges(changes); }

    std::span<const std::uint16_t> narrowIndices() const override { return indicesAs<std::uint16_t>(); }
    std::span<const std::uint32_t> wideIndices() const override { return indicesAs<std::uint32_t>(); }

private:
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
        const SlotWriter<Index> slots = _slots.writer();
        auto next = _progressive.base.begin();
        for (const FaceBlock& block : _progressive.blocks)
        {
            slots.fill(
                block.firstSlot, block.extent, [&](std::uint32_t i) { return !repeatsCorner(next[i]); },
                [&](std::uint32_t i) -> typename SlotWriter<Index>::Slot {
                    return {static_cast<Index>(next[i][0]), static_cast<Index>(next[i][1]),
                            static_cast<Index>(next[i][2])};
                });
            next += block.extent;
        }
        _faces =
            static_cast<std::uint32_t>(std::count_if(_progressive.base.begin(), _progressive.base.end(),
                                                     [](const Triangle& t) { return !repeatsCorner(t); }));
    }

    /// The head of a step's record.
    struct Head
    {
        std::uint32_t vanished, patched, wedges = 1;
        bool severalGo, facesMove;
        ByteReader counts{nullptr}; ///< of patched faces by wedge, if several are removed

        explicit Head(ByteReader& in)
        {
            const std::uint32_t head = in.byte();
            vanished = head & 3;
            patched = head >> 2 & 15;
            severalGo = head & 0x40;
            facesMove = head & 0x80;
            if (vanished == 3) [[unlikely]]
                vanished = in.number();
            if (patched == 15) [[unlikely]]
                patched = in.number();
            if (!severalGo) return;
            wedges = in.number();
            counts = in;
            for (std::uint32_t i = 0; i < wedges; ++i)
                in.number();
        }
    };

    void ecol()
    {
        const SlotWriter<Index> slots = _slots.writer();
        ByteReader in(_at);
        Head head(in);
        SlotLists lists(in, _widths.slot);
        for (std::uint32_t gone = 0; gone < head.wedges; ++gone)
        {
            const Index from = static_cast<Index>(_wedges - 1 - gone), to = _parents[from];
            lists.visit(head.severalGo ? head.counts.number() : head.patched,
                        [slots, from, to](std::uint32_t slot) { slots.patch(slot, from, to); });
        }
        lists.visit(head.vanished, [slots](std::uint32_t slot) { slots.makeHole(slot); });
        skipCodes(in, head.vanished);
        if (head.facesMove)
            for (std::uint32_t count = in.number(); count > 0; --count)
                _statistics.facesMoved += _rearranger.forth(in, slots);
        _at = skipLength(in.at(), static_cast<std::size_t>(in.at() - _at));
        _wedges -= head.wedges;
        _faces -= head.vanished;
        ++_steps;
        count(head);
    }

    void vsplit()
    {
        const std::byte* const begin = beginOfRecordBefore(_at);
        const SlotWriter<Index> slots = _slots.writer();
        std::uint32_t* const slotsOfStep = _slotsOfStep.data();
        Index* const fromOfPatched = _fromOfPatched.data();
        ByteReader in(begin);
        Head head(in);
        if (head.facesMove) [[unlikely]]
            backRearrangements(in, head);
        SlotLists lists(in, _widths.slot);
        std::uint32_t read = 0;
        _wedges += head.wedges;
        for (std::uint32_t gone = 0; gone < head.wedges; ++gone)
        {
            const Index from = static_cast<Index>(_wedges - 1 - gone), to = _parents[from];
            lists.visit(head.severalGo ? head.counts.number() : head.patched,
                        [&read, slots, slotsOfStep, fromOfPatched, from, to](std::uint32_t slot)
                        {
                            slots.patch(slot, to, from);
                            slotsOfStep[read] = slot;
                            fromOfPatched[read++] = from;
                        });
        }
        const std::uint32_t patched = read;
        lists.visit(head.vanished, [&read, slotsOfStep](std::uint32_t slot) { slotsOfStep[read++] = slot; });
        for (std::uint32_t i = patched; i < read; ++i)
            slots.put(slotsOfStep[i], vanishedFace(in, slots));
        _at = begin;
        _faces += head.vanished;
        --_steps;
        count(head);
    }

    void skipCodes(ByteReader& in, std::uint32_t vanished) const
    {
        for (; vanished > 0; --vanished)
            if (in.byte() == VanishedFace::kPlain) [[unlikely]]
                in.skip(3 * _widths.wedge.bytes);
    }

    /// Undoes the rearrangements. Their bytes follow the lists of slots, which refer to the slots before them.
    void backRearrangements(ByteReader in, Head head)
    {
        const auto ignore = [](std::uint32_t) {};
        SlotLists lists(in, _widths.slot);
        for (std::uint32_t gone = 0; gone < head.wedges; ++gone)
            lists.visit(head.severalGo ? head.counts.number() : head.patched, ignore);
        lists.visit(head.vanished, ignore);
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
            _statistics.facesMoved += _rearranger.back(rearrangement, _slots.writer());
        }
    }

    typename SlotWriter<Index>::Slot vanishedFace(ByteReader& codes, const SlotWriter<Index>& slots) const
    {
        const std::uint32_t code = codes.byte();
        if (code == VanishedFace::kPlain) [[unlikely]]
        {
            const std::uint32_t a = codes.fixed(_widths.wedge), b = codes.fixed(_widths.wedge),
                                c = codes.fixed(_widths.wedge);
            return {static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c)};
        }
        const VanishedFace face = kVanishedFaces[code];
        const Index from = _fromOfPatched[face.patched], to = _parents[from];
        typename SlotWriter<Index>::Slot corners{to, to, to};
        corners[face.third] = slots[_slotsOfStep[face.patched]][face.corner];
        corners[face.from] = from;
        return corners;
    }

    void count(const Head& head)
    {
        ++_statistics.steps;
        _statistics.facesPatched += head.patched;
        _statistics.facesVanished += head.vanished;
    }

    RecordWidths _widths;
    std::vector<Index> _parents;
    const std::byte* _at; ///< end of the last record that was played
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
