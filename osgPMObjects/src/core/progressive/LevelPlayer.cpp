// SPDX-License-Identifier: Apache-2.0
#include "LevelPlayer.h"

#include <type_traits>

#include "IndexSlots.h"
#include "RearrangementReader.h"
#include "StepRecord.h"

namespace osgPMObjects::core
{

namespace
{

template<class Index>
class IndexPlayer : public ProgressiveLevel::Player
{
public:
    explicit IndexPlayer(const ProgressiveMesh& progressive)
        : Player(progressive),
          _widths(progressive.mesh),
          _parents(progressive.parents.begin(), progressive.parents.end()),
          _at(progressive.records.data()),
          _slots(_faces),
          _slotsOfStep(progressive.mostSlotsOfStep),
          _rearrangements(progressive.mostRearrangements),
          _rearranger(progressive, _extents)
    {
        for (std::uint32_t slot = 0; slot < _faces; ++slot)
        {
            const auto& wedges = progressive.mesh.faces[slot].wedges;
            _slots.put(slot, {static_cast<Index>(wedges[0]), static_cast<Index>(wedges[1]),
                              static_cast<Index>(wedges[2])});
        }
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

    /// The head of a record.
    struct Head
    {
        std::uint32_t vanished, patched, wedges = 1;
        bool severalGo, facesMove;
        ByteReader counts{nullptr}; ///< of patched faces by wedge, where several go

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
        ByteReader in(_at);
        Head head(in);
        SlotLists lists(in, _widths.slot);
        for (std::uint32_t gone = 0; gone < head.wedges; ++gone)
        {
            const Index from = static_cast<Index>(_wedges - 1 - gone), to = _parents[from];
            lists.visit(head.severalGo ? head.counts.number() : head.patched,
                        [&](std::uint32_t slot) { _slots.patch(slot, from, to); });
        }
        lists.visit(head.vanished, [&](std::uint32_t slot) { _slots.makeHole(slot); });
        skipCodes(in, head.vanished);
        if (head.facesMove)
            for (std::uint32_t count = in.number(); count > 0; --count)
                _statistics.facesMoved += _rearranger.forth(in, _slots);
        _at = skipLength(in.at(), static_cast<std::size_t>(in.at() - _at));
        _wedges -= head.wedges;
        _faces -= head.vanished;
        ++_steps;
        count(head);
    }

    void vsplit()
    {
        const std::byte* const begin = beginOfRecordBefore(_at);
        ByteReader in(begin);
        Head head(in);
        SlotLists lists(in, _widths.slot);
        std::uint32_t read = 0;
        const auto keep = [&](std::uint32_t slot) { _slotsOfStep[read++] = slot; };
        ByteReader counts = head.counts;
        for (std::uint32_t gone = 0; gone < head.wedges; ++gone)
            lists.visit(head.severalGo ? counts.number() : head.patched, keep);
        lists.visit(head.vanished, keep);
        ByteReader codes = in;
        if (head.facesMove)
        {
            skipCodes(in, head.vanished);
            backRearrangements(in);
        }
        _wedges += head.wedges;
        std::uint32_t patched = 0;
        for (std::uint32_t gone = 0; gone < head.wedges; ++gone)
        {
            const std::uint32_t count = head.severalGo ? head.counts.number() : head.patched;
            const Index from = static_cast<Index>(_wedges - 1 - gone), to = _parents[from];
            for (const std::uint32_t end = patched + count; patched < end; ++patched)
            {
                _slots.patch(_slotsOfStep[patched], to, from);
                if (patched < VanishedFace::kPatched) _fromOfPatched[patched] = from;
            }
        }
        for (std::uint32_t i = 0; i < head.vanished; ++i)
            _slots.put(_slotsOfStep[patched + i], vanishedFace(codes));
        _at = begin;
        _faces += head.vanished;
        --_steps;
        count(head);
    }

    void skipCodes(ByteReader& in, std::uint32_t vanished) const
    {
        for (; vanished > 0; --vanished)
            if (in.byte() == VanishedFace::kPlain) [[unlikely]]
                in.skip(3 * _widths.wedge);
    }

    void backRearrangements(ByteReader& in)
    {
        const std::uint32_t count = in.number();
        for (std::uint32_t i = 0; i < count; ++i)
        {
            _rearrangements[i] = in.at();
            if (i + 1 < count) _rearranger.skip(in);
        }
        for (std::uint32_t i = count; i-- > 0;)
        {
            ByteReader rearrangement(_rearrangements[i]);
            _statistics.facesMoved += _rearranger.back(rearrangement, _slots);
        }
    }

    typename IndexSlots<Index>::Slot vanishedFace(ByteReader& codes)
    {
        typename IndexSlots<Index>::Slot face{};
        const std::uint32_t code = codes.byte();
        if (code == VanishedFace::kPlain) [[unlikely]]
        {
            for (Index& wedge : face)
                wedge = static_cast<Index>(codes.fixed(_widths.wedge));
            return face;
        }
        const std::uint32_t patched = code / VanishedFace::kCodesOfPatched;
        const std::uint32_t within = code % VanishedFace::kCodesOfPatched;
        const Index from = _fromOfPatched[patched];
        const Index third = _slots[_slotsOfStep[patched]][within / 6];
        const std::uint32_t corner = within % 6 / 2, next = corner == 2 ? 0 : corner + 1;
        const bool thirdIsNext = within & 1;
        face[corner] = from;
        face[next] = thirdIsNext ? third : _parents[from];
        face[3 - corner - next] = thirdIsNext ? _parents[from] : third;
        return face;
    }

    void count(const Head& head)
    {
        ++_statistics.steps;
        _statistics.facesPatched += head.patched;
        _statistics.facesVanished += head.vanished;
    }

    RecordWidths _widths;
    std::vector<Index> _parents;
    const std::byte* _at; ///< in the records: behind the last step that was taken
    IndexSlots<Index> _slots;
    std::vector<std::uint32_t> _slotsOfStep;
    std::vector<const std::byte*> _rearrangements;
    std::array<Index, VanishedFace::kPatched> _fromOfPatched{};
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
