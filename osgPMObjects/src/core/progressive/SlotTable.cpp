// SPDX-License-Identifier: Apache-2.0
#include "SlotTable.h"

#include <algorithm>
#include <cassert>

namespace osgPMObjects::core
{

void SlotTable::append(std::uint32_t group, std::span<const std::uint32_t> faces, std::uint32_t blockFaces)
{
    for (std::size_t begin = 0; begin < faces.size(); begin += blockFaces)
    {
        const auto count =
            static_cast<std::uint32_t>(std::min<std::size_t>(blockFaces, faces.size() - begin));
        _blocks.push_back({group, slotCount(), count, count, count});
        for (const std::uint32_t face : faces.subspan(begin, count))
        {
            if (face >= _slotOf.size()) _slotOf.resize(face + 1, kNone);
            _slotOf[face] = slotCount();
            _faceAt.push_back(face);
        }
    }
}

std::uint32_t SlotTable::blockOf(std::uint32_t slot) const
{
    const auto after =
        std::upper_bound(_blocks.begin(), _blocks.end(), slot,
                         [](std::uint32_t s, const SlotBlock& block) { return s < block.first; });
    return static_cast<std::uint32_t>(after - _blocks.begin()) - 1;
}

void SlotTable::removeFace(std::uint32_t face)
{
    const std::uint32_t block = blockOf(_slotOf[face]);
    --_blocks[block].live;
    if (std::find(_blocksWithRemovals.begin(), _blocksWithRemovals.end(), block) == _blocksWithRemovals.end())
        _blocksWithRemovals.push_back(block);
    _faceAt[_slotOf[face]] = kNone;
    _slotOf[face] = kNone;
}

void SlotTable::put(std::uint32_t face, std::uint32_t slot)
{
    _moves += _slotOf[face] != slot;
    _slotOf[face] = slot;
    _faceAt[slot] = face;
}

void SlotTable::chain(std::vector<std::uint32_t> slots)
{
    assert(faceAt(slots.front()) == kNone);
    const std::uint32_t last = blockOf(slots.back());
    for (std::size_t i = 0; i + 1 < slots.size(); ++i)
    {
        --_blocks[blockOf(slots[i + 1])].live;
        ++_blocks[blockOf(slots[i])].live;
        put(_faceAt[slots[i + 1]], slots[i]);
    }
    _faceAt[slots.back()] = kNone;
    _rearrangements.push_back({RearrangementKind::chain, {last}, {_blocks[last].extent}, std::move(slots)});
    --_blocks[last].extent;
}

std::vector<std::uint32_t> SlotTable::fillHoles(std::uint32_t block)
{
    const SlotBlock& b = _blocks[block];
    std::vector<std::uint32_t> filled;
    for (std::uint32_t hole = b.first; b.extent > b.live;)
    {
        const std::uint32_t last = b.first + b.extent - 1;
        if (faceAt(last) == kNone)
        {
            chain({last});
            continue;
        }
        while (faceAt(hole) != kNone)
            ++hole;
        filled.push_back(hole);
        chain({hole, last});
    }
    return filled;
}

void SlotTable::rewrite(std::vector<std::uint32_t> blocks, std::span<const std::uint32_t> faces)
{
    refill(RearrangementKind::rewrite, std::move(blocks), faces);
}

void SlotTable::permute(std::uint32_t block, std::span<const std::uint32_t> faces)
{
    refill(RearrangementKind::cycles, {block}, faces);
}

void SlotTable::refill(RearrangementKind kind, std::vector<std::uint32_t> blocks,
                       std::span<const std::uint32_t> faces)
{
    Rearrangement& rearrangement = _rearrangements.emplace_back();
    rearrangement.kind = kind;
    for (const std::uint32_t face : faces)
        rearrangement.slots.push_back(_slotOf[face]);
    std::size_t next = 0;
    for (const std::uint32_t b : blocks)
    {
        SlotBlock& block = _blocks[b];
        rearrangement.extents.push_back(block.extent);
        std::fill_n(_faceAt.begin() + block.first, block.extent, kNone);
        block.extent = block.live =
            static_cast<std::uint32_t>(std::min<std::size_t>(block.capacity, faces.size() - next));
        for (std::uint32_t i = 0; i < block.extent; ++i)
            put(faces[next++], block.first + i);
    }
    assert(next == faces.size());
    rearrangement.blocks = std::move(blocks);
}

std::uint32_t SlotTable::liveNeighbour(std::uint32_t block, int direction) const
{
    const std::uint32_t group = _blocks[block].group;
    for (block += direction; block < _blocks.size() && _blocks[block].group == group; block += direction)
        if (_blocks[block].live > 0) return block;
    return kNone;
}

void SlotTable::appendFaces(std::uint32_t block, std::vector<std::uint32_t>& faces) const
{
    for (std::uint32_t i = 0; i < _blocks[block].extent; ++i)
        if (const std::uint32_t face = _faceAt[_blocks[block].first + i]; face != kNone)
            faces.push_back(face);
}

std::vector<Rearrangement> SlotTable::takeRearrangements()
{
    _blocksWithRemovals.clear();
    std::vector<Rearrangement> taken;
    taken.swap(_rearrangements);
    return taken;
}

} // namespace osgPMObjects::core
