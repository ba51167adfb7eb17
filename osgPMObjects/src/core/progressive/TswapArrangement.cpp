// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osgPMObjects/core/order/TriangleOrders.h>

#include "FaceArrangement.h"

namespace osgPMObjects::core
{

namespace
{

class TswapArrangement : public FaceArrangement
{
public:
    explicit TswapArrangement(const ArrangementSettings& settings) : _settings(settings) {}

    void begin(const LevelWalk& walk, SlotTable& slots) override
    {
        LocalNumbers numbers(walk);
        std::uint32_t material = 0;
        for (const std::vector<std::uint32_t>& faces : liveFacesByMaterial(walk))
        {
            const std::vector<Triangle> triangles = numbers.trianglesOf(walk, faces);
            std::vector<std::uint32_t> order = libraryOrder(triangles, numbers.count());
            for (std::uint32_t& face : order)
                face = faces[face];
            slots.append(material++, order, walk.faceCount());
        }
    }

    void afterStep(const LevelWalk& walk, SlotTable& slots) override
    {
        for (const std::uint32_t block : slots.buriedIn())
        {
            const SlotBlock& b = slots.blocks()[block];
            std::uint32_t hole = b.first;
            while (true)
            {
                while (b.extent > b.live && slots.faceAt(lastOf(b)) == SlotTable::kNone)
                    slots.chain({lastOf(b)});
                if (b.extent == b.live) break;
                while (slots.faceAt(hole) != SlotTable::kNone)
                    ++hole;
                slots.chain(cycleFrom(hole, b, walk, slots));
            }
        }
    }

private:
    static std::uint32_t lastOf(const SlotBlock& block) { return block.first + block.extent - 1; }

    /// The slots that a hole wanders through until it is the last.
    std::vector<std::uint32_t> cycleFrom(std::uint32_t hole, const SlotBlock& block, const LevelWalk& walk,
                                         const SlotTable& slots) const
    {
        std::vector<std::uint32_t> cycle{hole};
        while (cycle.back() != lastOf(block))
        {
            const std::uint32_t next =
                cycle.size() < _settings.tswapLength ? bestFor(cycle, block, walk, slots) : lastOf(block);
            cycle.push_back(next);
        }
        return cycle;
    }

    /// The slot of the face that is drawn after what is before the hole for the least transforms, compared with where it is now.
    std::uint32_t bestFor(const std::vector<std::uint32_t>& cycle, const SlotBlock& block,
                          const LevelWalk& walk, const SlotTable& slots) const
    {
        const std::uint32_t hole = cycle.back();
        const std::vector<std::uint32_t> cached = cacheBefore(hole, block, walk, slots);
        std::uint32_t best = lastOf(block);
        float most = gainOf(best, hole, cached, block, walk, slots);
        for (const std::uint32_t wedge : cached)
            for (const std::uint32_t face : walk.facesOf(wedge))
            {
                if (!walk.isLive(face)) continue;
                const std::uint32_t slot = slots.slotOf(face);
                if (slot < block.first || slot > lastOf(block) ||
                    std::find(cycle.begin(), cycle.end(), slot) != cycle.end())
                    continue;
                const float gain = gainOf(slot, hole, cached, block, walk, slots);
                if (gain <= most) continue;
                most = gain;
                best = slot;
            }
        return best;
    }

    /// Transforms saved when the face of a slot is drawn in the hole instead of where it is, and what it is worth that the line of the
    /// processor's cache is touched anyway.
    float gainOf(std::uint32_t slot, std::uint32_t hole, const std::vector<std::uint32_t>& cached,
                 const SlotBlock& block, const LevelWalk& walk, const SlotTable& slots) const
    {
        const Triangle& triangle = walk.triangle(slots.faceAt(slot));
        const int here = missesOf(triangle, cached);
        const int there = missesOf(triangle, cacheBefore(slot, block, walk, slots));
        constexpr std::uint32_t kSlotsOfLine = 10; // 64 bytes of 16-bit indices
        return static_cast<float>(there - here) +
               (slot / kSlotsOfLine == hole / kSlotsOfLine ? _settings.touchedLineWeight : 0.0f);
    }

    static int missesOf(const Triangle& triangle, const std::vector<std::uint32_t>& cached)
    {
        return static_cast<int>(
            std::count_if(triangle.begin(), triangle.end(),
                          [&](std::uint32_t wedge)
                          { return std::find(cached.begin(), cached.end(), wedge) == cached.end(); }));
    }

    /// The wedges that were used last before a slot, as many as the cache holds.
    std::vector<std::uint32_t> cacheBefore(std::uint32_t slot, const SlotBlock& block, const LevelWalk& walk,
                                           const SlotTable& slots) const
    {
        std::vector<std::uint32_t> cached;
        while (slot-- > block.first && cached.size() < _settings.cacheSize)
        {
            if (slots.faceAt(slot) == SlotTable::kNone) continue;
            for (const std::uint32_t wedge : walk.triangle(slots.faceAt(slot)))
                if (std::find(cached.begin(), cached.end(), wedge) == cached.end()) cached.push_back(wedge);
        }
        return cached;
    }

    ArrangementSettings _settings;
};

} // namespace

std::unique_ptr<FaceArrangement> tswapArrangement(const ArrangementSettings& settings)
{
    return std::make_unique<TswapArrangement>(settings);
}

} // namespace osgPMObjects::core
