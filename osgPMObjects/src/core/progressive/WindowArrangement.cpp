// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>

#include <foundation/VertexCache.h>

#include <osgPMObjects/core/order/TriangleOrders.h>

#include "FaceArrangement.h"
#include "Lifetimes.h"

namespace osgPMObjects::core
{

namespace
{

using Faces = std::vector<std::uint32_t>;

/// Implements Arrangement::windows. Source: the authors.
class WindowArrangement : public FaceArrangement
{
public:
    WindowArrangement(const ArrangementSettings& settings, std::uint32_t blockFaces)
        : _cacheSize(settings.cacheSize),
          _blockFaces(blockFaces),
          _windowBlocks(std::max(2u, settings.windowBlocks))
    {
    }

    void begin(const LevelWalk& walk, SlotTable& slots) override
    {
        _numbers = std::make_unique<LocalNumbers>(walk);
        _lifetimes = std::make_unique<Lifetimes>(walk.split());
        _cache = std::make_unique<foundation::FifoCache>(
            static_cast<std::uint32_t>(walk.split().mesh.wedgeCount()), _cacheSize);
        std::uint32_t material = 0;
        for (const Faces& faces : liveFacesByMaterial(walk))
            slots.append(material++, bestOrder(walk, faces), _blockFaces);
    }

    void afterStep(const LevelWalk& walk, SlotTable& slots) override
    {
        const Faces touched = slots.blocksWithRemovals();
        for (const std::uint32_t block : touched)
            if (Faces window = windowAround(block, slots); !window.empty())
            {
                Faces faces;
                for (const std::uint32_t b : window)
                    slots.appendFaces(b, faces);
                slots.rewrite(std::move(window), bestOrder(walk, faces));
            }
    }

private:
    /// Returns neighbouring blocks around `block` whose faces fit into one block less; fewer than _windowBlocks only if the
    /// group has no more. Empty: they do not fit.
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

    /// Tells whether a window's faces fit into one block less, with a margin. A window that waits longer needs fewer
    /// moves and shorter records, but has more holes. With this margin records are shortest and the order is hardly
    /// worse. A single block waits until the same share of it has vanished.
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
        constexpr std::uint32_t kMoreRoomPercent = 64;
        return live + goes + goes * kMoreRoomPercent / 100 <= (window.size() > 1 ? room : extents);
    }

    /// Returns the order, out of several, that costs least until a share of the faces has vanished.
    Faces bestOrder(const LevelWalk& walk, const Faces& faces)
    {
        if (faces.size() < 2) return faces;
        Faces best = faces;
        std::uint64_t least = costOf(walk, best);
        const auto forQueue = [this](std::span<const Triangle> triangles, std::uint32_t wedges)
        { return localityOrder(triangles, wedges, _cacheSize); };
        for (const Faces& order : std::array{_numbers->ordered(walk, faces, libraryOrder),
                                             _numbers->ordered(walk, faces, forQueue)})
        {
            const std::uint64_t cost = costOf(walk, order);
            if (cost >= least) continue;
            least = cost;
            best = order;
        }
        return best;
    }

    /// Returns the transformed wedges, summed over some levels from now to the next ordering of the faces.
    std::uint64_t costOf(const LevelWalk& walk, const Faces& faces)
    {
        Faces ends;
        ends.reserve(faces.size());
        for (const std::uint32_t face : faces)
            ends.push_back(_lifetimes->end(face));
        std::sort(ends.begin(), ends.end());
        constexpr std::size_t kLevels = 4;
        std::uint64_t cost = 0;
        for (std::size_t level = 0; level < kLevels; ++level)
        {
            const std::size_t gone = faces.size() * level / ((kLevels - 1) * _windowBlocks);
            cost += transformsAfter(walk, faces,
                                    level == 0 ? walk.stepsTaken() : std::min(ends[gone], walk.stepCount()));
        }
        return cost;
    }

    std::uint64_t transformsAfter(const LevelWalk& walk, const Faces& faces, std::uint32_t steps)
    {
        _cache->empty();
        const std::uint64_t before = _cache->misses();
        for (const std::uint32_t face : faces)
            if (_lifetimes->end(face) > steps)
                for (const std::uint32_t wedge : walk.triangle(face))
                    _cache->transform(_lifetimes->wedgeAfter(wedge, steps));
        return _cache->misses() - before;
    }

    std::uint32_t _cacheSize, _blockFaces, _windowBlocks;
    std::unique_ptr<LocalNumbers> _numbers;
    std::unique_ptr<Lifetimes> _lifetimes;
    std::unique_ptr<foundation::FifoCache> _cache;
};

} // namespace

std::unique_ptr<FaceArrangement> windowArrangement(const ArrangementSettings& settings)
{
    constexpr std::uint32_t kBlockFaces = 1024;
    return std::make_unique<WindowArrangement>(settings,
                                               settings.blockFaces == 0 ? kBlockFaces : settings.blockFaces);
}

} // namespace osgPMObjects::core
