// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>

#include "FaceArrangement.h"
#include "WindowOrder.h"

namespace osgPMObjects::core
{

namespace
{

using Faces = std::vector<std::uint32_t>;

/// Implements Arrangement::windows. Source: the authors.
class WindowArrangement : public FaceArrangement
{
public:
    explicit WindowArrangement(const ArrangementSettings& settings)
        : _cacheSize(settings.cacheSize),
          _blockFaces(settings.blockFaces),
          _windowBlocks(std::max(2u, settings.windowBlocks))
    {
    }

    void begin(const LevelWalk& walk, SlotTable& slots) override
    {
        _order = std::make_unique<WindowOrder>(walk, _cacheSize);
        std::uint32_t material = 0;
        for (const Faces& faces : liveFacesByMaterial(walk))
            slots.append(material++, _order->ordered(faces), blockFacesOf(faces.size()));
    }

    void afterStep(const LevelWalk&, SlotTable& slots) override
    {
        const Faces touched = slots.blocksWithRemovals();
        for (const std::uint32_t block : touched)
            if (Faces window = windowAround(block, slots); !window.empty())
            {
                Faces faces;
                for (const std::uint32_t b : window)
                    slots.appendFaces(b, faces);
                slots.rewrite(std::move(window), _order->ordered(faces));
            }
    }

private:
    /// Returns the faces of a block in a group of some faces. Vertices on the border of a window are
    /// transformed once more, so large windows are better, but with few windows many holes are drawn.
    std::uint32_t blockFacesOf(std::size_t faces) const
    {
        constexpr std::size_t kBlocks = 20, kLeastFaces = 1024, kMostFaces = 3072;
        return _blockFaces != 0
                   ? _blockFaces
                   : static_cast<std::uint32_t>(std::clamp(faces / kBlocks, kLeastFaces, kMostFaces));
    }

    /// Returns neighbouring blocks around `block` whose faces fit into one block less; fewer than
    /// _windowBlocks only if the group has no more. Empty: they do not fit.
    Faces windowAround(std::uint32_t block, const SlotTable& slots) const
    {
        if (slots.blocks()[block].live == 0) return slots.blocks()[block].extent > 0 ? Faces{block} : Faces{};
        Faces row{block};
        for (std::uint32_t b = block; row.size() < _windowBlocks;)
        {
            b = slots.liveNeighbour(b, -1);
            if (b == SlotTable::kNone) break;
            row.insert(row.begin(), b);
        }
        const std::size_t middle = row.size() - 1;
        for (std::uint32_t b = block; row.size() < middle + _windowBlocks;)
        {
            b = slots.liveNeighbour(b, +1);
            if (b == SlotTable::kNone) break;
            row.push_back(b);
        }
        const std::size_t length = std::min<std::size_t>(_windowBlocks, row.size());
        for (std::size_t begin = middle + 1 - std::min(middle + 1, length);
             begin <= middle && begin + length <= row.size(); ++begin)
            if (hasRoomInLess(slots, std::span(row).subspan(begin, length)))
                return {row.begin() + begin, row.begin() + begin + length};
        return {};
    }

    /// Tells whether a window's faces fit into one block less, with a margin. A window that waits longer
    /// needs fewer moves and shorter records, but has more holes. With this margin records are shortest and
    /// the order is hardly worse. A single block waits until the same share of it has vanished.
    bool hasRoomInLess(const SlotTable& slots, std::span<const std::uint32_t> window) const
    {
        std::uint32_t live = 0, extents = 0, room = 0, least = ~0u;
        for (const std::uint32_t b : window)
        {
            const SlotBlock& block = slots.blocks()[b];
            live += block.live;
            extents += block.extent;
            room += block.capacity;
            least = std::min(least, block.capacity);
        }
        const std::uint32_t goes = window.size() > 1 ? least : extents / _windowBlocks;
        const std::uint32_t moreRoomPercent = moreRoomFor(slots.slotCount());
        return live + goes + goes * moreRoomPercent / 100 <= (window.size() > 1 ? room : extents);
    }

    /// The spare room for which a window waits, in per cent of a block: the shorter the records of a mesh,
    /// the more moves fit in 16 bytes a vertex. More than 65 536 slots need three bytes in records. Found by
    /// trial on closed scanned meshes.
    static std::uint32_t moreRoomFor(std::uint32_t slots)
    {
        if (slots > 0x10000) return 85;
        return slots > 0x5000 ? 72 : 60;
    }

    std::uint32_t _cacheSize, _blockFaces, _windowBlocks;
    std::unique_ptr<WindowOrder> _order;
};

} // namespace

std::unique_ptr<FaceArrangement> windowArrangement(const ArrangementSettings& settings)
{
    return std::make_unique<WindowArrangement>(settings);
}

} // namespace osgPMObjects::core
