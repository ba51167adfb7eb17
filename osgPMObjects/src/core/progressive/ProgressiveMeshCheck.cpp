// SPDX-License-Identifier: Apache-2.0
#include "ProgressiveMeshCheck.h"

#include <algorithm>
#include <cmath>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>

#include "StepRecord.h"

namespace osgPMObjects::core
{

namespace
{

/// Reads as ByteReader does, but not beyond an end.
class CheckedReader
{
public:
    CheckedReader(const std::byte* at, const std::byte* end) : _at(at), _end(end) {}

    std::uint32_t byte()
    {
        if (_at == _end)
        {
            _isGood = false;
            return 0;
        }
        return static_cast<std::uint32_t>(*_at++);
    }

    std::uint32_t number()
    {
        std::uint64_t value = 0;
        for (int shift = 0; shift < 35; shift += 7)
        {
            const std::uint64_t next = byte();
            value |= (next & 0x7f) << shift;
            if (next >= 0x80) continue;
            if (value > kMost) _isGood = false;
            return _isGood ? static_cast<std::uint32_t>(value) : 0;
        }
        _isGood = false;
        return 0;
    }

    std::int32_t difference()
    {
        const std::uint32_t value = number();
        return static_cast<std::int32_t>(value >> 1) ^ -static_cast<std::int32_t>(value & 1);
    }

    std::uint32_t fixed(const FixedWidth& width)
    {
        std::uint32_t value = 0;
        for (int i = 0; i < width.bytes; ++i)
            value |= byte() << (8 * i);
        return value;
    }

    bool isGood() const { return _isGood; }
    const std::byte* at() const { return _at; }

private:
    static constexpr std::uint64_t kMost = 0x7fffffff; ///< sums of two do not overflow

    const std::byte* _at;
    const std::byte* _end;
    bool _isGood = true;
};

/// Goes over the records from the coarsest level to the finest, as vsplits do.
class RecordCheck
{
public:
    explicit RecordCheck(const ProgressiveMesh& progressive)
        : _progressive(progressive),
          _widths(progressive),
          _wedges(static_cast<std::uint32_t>(progressive.mesh.wedgeCount()))
    {
        for (const FaceBlock& block : progressive.blocks)
            _extents.push_back(block.extent);
        const auto& positions = progressive.mesh.wedgePositions;
        const std::size_t left = progressive.mesh.positions.size() - progressive.stepCount;
        while (_wedges > 0 && positions[_wedges - 1] >= left)
            --_wedges;
    }

    /// Empty: some record is not sound.
    std::optional<PlayerNeeds> needs()
    {
        const std::byte* const begin = _progressive.records.data();
        const std::byte* end = begin + _progressive.records.size() - kRecordPadding;
        for (std::uint32_t step = _progressive.stepCount; step-- > 0;)
        {
            const std::byte* const from = beginBefore(begin, end);
            if (from == nullptr || !isRecord(from, end, step)) return {};
            end = from;
        }
        if (end != begin) return {};
        return _needs;
    }

private:
    static const std::byte* beginBefore(const std::byte* begin, const std::byte* end)
    {
        if (end == begin) return nullptr;
        std::size_t length = static_cast<std::size_t>(end[-1]) + 1;
        if (length == 1)
        {
            if (end - begin < 5) return nullptr;
            length = std::size_t{CheckedReader(end - 5, end).fixed(FixedWidth(4))} + 5;
        }
        return length > static_cast<std::size_t>(end - begin) ? nullptr : end - length;
    }

    bool isRecord(const std::byte* begin, const std::byte* end, std::uint32_t step)
    {
        CheckedReader in(begin, end);
        const std::uint32_t head = in.byte();
        std::uint32_t vanished = head & 3, patched = head >> 2 & 15, wedges = 1;
        if (vanished == 3) vanished = in.number();
        if (patched == 15) patched = in.number();
        std::vector<std::uint32_t> patchedOfWedge{patched};
        if (head & 0x40)
        {
            wedges = in.number();
            if (wedges > _progressive.mesh.wedgeCount() - _wedges) return false;
            patchedOfWedge.clear();
            std::uint64_t sum = 0;
            for (std::uint32_t i = 0; i < wedges; ++i)
                sum += patchedOfWedge.emplace_back(in.number());
            if (sum != patched) return false;
        }
        if (wedges != wedgesOf(step) || !in.isGood()) return false;
        if (std::uint64_t{patched} + vanished > _progressive.slotCount) return false;
        _wedges += wedges;
        std::vector<std::uint32_t> slots;
        SlotLists lists(in, _widths.slot);
        const auto keep = [&](std::uint32_t slot) { slots.push_back(slot); };
        for (const std::uint32_t count : patchedOfWedge)
            lists.visit(count, keep);
        lists.visit(vanished, keep);
        for (std::uint32_t i = 0; i < vanished; ++i)
            if (!isVanishedFace(in, patched)) return false;
        if ((head & 0x80) && !areRearrangements(in)) return false;
        const std::size_t length = static_cast<std::size_t>(in.at() - begin);
        _needs.slotsOfStep = std::max(_needs.slotsOfStep, patched + vanished);
        return in.isGood() && skipLength(in.at(), length) == end &&
               std::all_of(slots.begin(), slots.end(), [this](std::uint32_t s) { return isDrawn(s); });
    }

    std::uint32_t wedgesOf(std::uint32_t step) const
    {
        const auto& positions = _progressive.mesh.wedgePositions;
        const std::size_t position = _progressive.mesh.positions.size() - 1 - step;
        std::uint32_t count = 0;
        while (_wedges + count < positions.size() && positions[_wedges + count] == position)
            ++count;
        return count;
    }

    bool isVanishedFace(CheckedReader& in, std::uint32_t patched) const
    {
        const std::uint32_t code = in.byte();
        if (code != VanishedFace::kPlain) return VanishedFace::ofCode(code).patched < patched;
        for (int corner = 0; corner < 3; ++corner)
            if (in.fixed(_widths.wedge) >= _wedges) return false;
        return true;
    }

    bool isDrawn(std::uint32_t slot) const
    {
        const auto after =
            std::upper_bound(_progressive.blocks.begin(), _progressive.blocks.end(), slot,
                             [](std::uint32_t s, const FaceBlock& b) { return s < b.firstSlot; });
        if (after == _progressive.blocks.begin()) return false;
        return slot - (after - 1)->firstSlot < _extents[after - 1 - _progressive.blocks.begin()];
    }

    /// Those of a record follow each other; the last is undone first.
    bool areRearrangements(CheckedReader& in)
    {
        const std::uint32_t count = in.number();
        if (count > _progressive.records.size()) return false;
        std::vector<Rearrangement> all;
        for (std::uint32_t i = 0; i < count && in.isGood(); ++i)
        {
            const std::uint32_t head = in.number();
            if (head >> 1 > _progressive.slotCount) return false;
            all.push_back(head & 1 ? readChain(in, head >> 1) : readRewrite(in, head >> 1));
        }
        if (!in.isGood()) return false;
        _needs.rearrangements = std::max(_needs.rearrangements, count);
        return std::all_of(all.rbegin(), all.rend(),
                           [this](const Rearrangement& r)
                           { return r.isChain ? undoChain(r) : undoRewrite(r); });
    }

    Rearrangement readChain(CheckedReader& in, std::uint32_t moves)
    {
        Rearrangement chain{true, {in.number()}, {}, {}};
        chain.slots.push_back(in.fixed(_widths.slot));
        for (std::uint32_t i = 0; i < moves && in.isGood(); ++i)
            chain.slots.push_back(chain.slots.back() + static_cast<std::uint32_t>(in.difference()));
        return chain;
    }

    bool undoChain(const Rearrangement& chain)
    {
        const std::uint32_t block = chain.blocks.front();
        if (block >= _extents.size()) return false;
        const std::uint32_t first = _progressive.blocks[block].firstSlot;
        if (_extents[block] >= _progressive.endSlot(block) - first) return false;
        ++_extents[block];
        needSlots(chain.slots.size());
        return chain.slots.back() == first + _extents[block] - 1 &&
               std::all_of(chain.slots.begin(), chain.slots.end(),
                           [this](std::uint32_t slot) { return isDrawn(slot); });
    }

    Rearrangement readRewrite(CheckedReader& in, std::uint32_t count)
    {
        Rearrangement rewrite;
        for (std::uint32_t b = 0; b < count && in.isGood(); ++b)
            rewrite.blocks.push_back(in.number() + (b == 0 ? 0 : rewrite.blocks.back()));
        for (std::uint32_t b = 0; b < count && in.isGood(); ++b)
            rewrite.extents.push_back(in.number());
        const std::uint32_t live = in.number();
        std::uint32_t expected = 0;
        for (std::uint32_t i = 0; i < live && in.isGood(); ++i)
        {
            const std::uint32_t source = expected + static_cast<std::uint32_t>(in.difference());
            rewrite.slots.push_back(source);
            expected = source + 1;
        }
        return rewrite;
    }

    bool undoRewrite(const Rearrangement& rewrite)
    {
        std::size_t live = 0, slots = 0;
        for (std::size_t b = 0; b < rewrite.blocks.size(); ++b)
        {
            const std::uint32_t block = rewrite.blocks[b];
            if (block >= _extents.size() || (b > 0 && block <= rewrite.blocks[b - 1])) return false;
            const std::uint32_t capacity = _progressive.endSlot(block) - _progressive.blocks[block].firstSlot;
            // They were filled one after the other.
            if (_extents[block] != std::min<std::size_t>(capacity, rewrite.slots.size() - live)) return false;
            live += _extents[block];
            if (rewrite.extents[b] > capacity) return false;
            slots += rewrite.extents[b];
            _extents[block] = rewrite.extents[b];
        }
        needSlots(std::max(live, slots));
        std::vector<bool> isTaken(slots, false);
        for (const std::uint32_t source : rewrite.slots)
        {
            if (source >= slots || isTaken[source]) return false;
            isTaken[source] = true;
        }
        return live == rewrite.slots.size();
    }

    void needSlots(std::size_t slots)
    {
        _needs.slotsMoved = std::max(_needs.slotsMoved, static_cast<std::uint32_t>(slots));
    }

    const ProgressiveMesh& _progressive;
    RecordWidths _widths;
    std::uint32_t _wedges;
    std::vector<std::uint32_t> _extents;
    PlayerNeeds _needs;
};

bool risesToItsEnd(const std::vector<std::uint32_t>& wedgePositions, std::size_t positions)
{
    // Every position has wedges, and they lie together.
    std::uint32_t expected = 0;
    for (const std::uint32_t position : wedgePositions)
    {
        if (position != expected && position != expected - 1) return false;
        if (position == expected) ++expected;
    }
    return expected == positions;
}

bool areParents(const ProgressiveMesh& p)
{
    const std::size_t left = p.mesh.positions.size() - p.stepCount;
    for (std::uint32_t wedge = 0; wedge < p.parents.size(); ++wedge)
    {
        const bool stays = p.mesh.wedgePositions[wedge] < left;
        if (p.parents[wedge] > wedge || (stays && p.parents[wedge] != wedge)) return false;
        if (p.parents[wedge] != wedge &&
            p.mesh.wedgePositions[p.parents[wedge]] == p.mesh.wedgePositions[wedge])
            return false;
    }
    return p.parents.size() == p.mesh.wedgeCount();
}

bool areGroupsAndBlocks(const ProgressiveMesh& p)
{
    for (std::uint32_t g = 0; g < p.groups.size(); ++g)
    {
        if (p.groups[g].material >= p.mesh.materials.size()) return false;
        if (g == 0 ? p.groups[g].firstBlock != 0 : p.groups[g].firstBlock <= p.groups[g - 1].firstBlock)
            return false;
        if (p.groups[g].firstBlock >= p.blocks.size()) return false;
    }
    if (p.groups.empty() != p.blocks.empty()) return false;
    std::size_t drawn = 0;
    for (std::uint32_t b = 0; b < p.blocks.size(); ++b)
    {
        if (b == 0 && p.blocks[b].firstSlot != 0) return false;
        if (p.blocks[b].firstSlot >= p.slotCount || p.endSlot(b) <= p.blocks[b].firstSlot) return false;
        if (p.blocks[b].extent > p.endSlot(b) - p.blocks[b].firstSlot) return false;
        drawn += p.blocks[b].extent;
    }
    return drawn == p.base.size();
}

bool isBase(const ProgressiveMesh& p)
{
    const std::size_t left = p.mesh.positions.size() - p.stepCount;
    return std::all_of(p.base.begin(), p.base.end(),
                       [&](const Triangle& t)
                       {
                           return repeatsCorner(t) ||
                                  std::all_of(t.begin(), t.end(),
                                              [&](std::uint32_t wedge) {
                                                  return wedge < p.mesh.wedgeCount() &&
                                                         p.mesh.wedgePositions[wedge] < left;
                                              });
                       });
}

template<class Vector>
bool areFinite(const std::vector<Vector>& values)
{
    return std::all_of(values.begin(), values.end(),
                       [](const Vector& v)
                       {
                           for (int i = 0; i < Vector::length(); ++i)
                               if (!std::isfinite(v[i])) return false;
                           return true;
                       });
}

bool areVerticesFinite(const Mesh& mesh)
{
    return areFinite(mesh.positions) && areFinite(mesh.normals) && areFinite(mesh.texCoords[0]) &&
           areFinite(mesh.texCoords[1]) && areFinite(mesh.colours);
}

bool areErrors(const ProgressiveMesh& p)
{
    const std::size_t kept =
        (std::size_t{p.stepCount} + ProgressiveMesh::kErrorStride - 1) / ProgressiveMesh::kErrorStride;
    const auto falls = [](const LevelError& a, const LevelError& b)
    {
        return !(a.distance <= b.distance && a.normal <= b.normal && a.texCoord <= b.texCoord &&
                 a.colour <= b.colour);
    };
    const auto isFinite = [](const LevelError& e)
    { return std::isfinite(e.distance + e.normal + e.texCoord + e.colour); };
    return p.errors.size() == kept && std::all_of(p.errors.begin(), p.errors.end(), isFinite) &&
           isFinite(p.finestError) && (p.errors.empty() || !falls(p.finestError, p.errors.front())) &&
           std::adjacent_find(p.errors.begin(), p.errors.end(), falls) == p.errors.end();
}

bool isArray(std::size_t size, const ProgressiveMesh& p)
{
    return size == 0 || size == p.mesh.wedgeCount();
}

} // namespace

std::optional<PlayerNeeds> needsOf(const ProgressiveMesh& p)
{
    const bool isSound = p.stepCount <= p.mesh.positions.size() && p.records.size() >= kRecordPadding &&
                         p.slotBytes >= 1 && p.slotBytes <= 4 && p.wedgeBytes >= 1 && p.wedgeBytes <= 4 &&
                         p.slotCount <= (1u << 30) && p.mesh.faces.empty() &&
                         isArray(p.mesh.normals.size(), p) && isArray(p.mesh.texCoords[0].size(), p) &&
                         isArray(p.mesh.texCoords[1].size(), p) && isArray(p.mesh.colours.size(), p) &&
                         risesToItsEnd(p.mesh.wedgePositions, p.mesh.positions.size()) && areParents(p) &&
                         areGroupsAndBlocks(p) && isBase(p) && areErrors(p) && areVerticesFinite(p.mesh);
    return isSound ? RecordCheck(p).needs() : std::nullopt;
}

bool isValid(const ProgressiveMesh& progressive)
{
    const auto needs = needsOf(progressive);
    if (!needs || needs->slotsOfStep > progressive.mostSlotsOfStep ||
        needs->rearrangements > progressive.mostRearrangements ||
        needs->slotsMoved > progressive.mostSlotsMoved)
        return false;
    // The way down undoes the way up, as the records are sound; that it leads back says that they belong to each other.
    ProgressiveLevel level(progressive);
    const auto drawn = [&]
    {
        std::vector<Triangle> faces;
        std::vector<SlotRange> ranges;
        for (std::uint32_t group = 0; group < progressive.groups.size(); ++group)
            level.appendRanges(group, ranges);
        for (const SlotRange& range : ranges)
            for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
                faces.push_back(level.face(slot));
        return faces;
    };
    const std::vector<Triangle> base = drawn();
    level.moveTo(0);
    const std::uint32_t faces = level.faceCount();
    level.moveTo(progressive.stepCount);
    return base == drawn() && faces <= progressive.slotCount;
}

} // namespace osgPMObjects::core
