// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "FaceArrangement.h"
#include "GreedyOrder.h"

namespace osgPMObjects::core
{

namespace
{

/// Implements Arrangement::tswap. Source: see tswapArrangement().
class TswapArrangement : public FaceArrangement
{
public:
    explicit TswapArrangement(const ArrangementSettings& settings)
        : _stepShare(settings.tswapStep),
          _first{settings.cacheSize, {}, settings.lookAhead},
          _rules{settings.cacheSize, {settings.stayWeight, settings.touchedLineWeight}, settings.lookAhead}
    {
    }

    void begin(const LevelWalk& walk, SlotTable& slots) override
    {
        _numbers = std::make_unique<LocalNumbers>(walk);
        std::uint32_t material = 0;
        for (const std::vector<std::uint32_t>& faces : liveFacesByMaterial(walk))
            slots.append(material++, ordered(walk, faces, _first, {}), walk.faceCount());
        for (const SlotBlock& block : slots.blocks())
            _orderedAt.push_back(block.live);
        _isWritten.resize(slots.slotCount(), false);
    }

    void afterStep(const LevelWalk& walk, SlotTable& slots) override
    {
        for (const LevelWalk::Patch& patch : walk.patches())
            if (walk.isLive(patch.face)) _isWritten[slots.slotOf(patch.face)] = true;
        const std::vector<std::uint32_t> touched = slots.blocksWithRemovals();
        for (const std::uint32_t block : touched)
        {
            const std::uint32_t before = _orderedAt[block], live = slots.blocks()[block].live;
            if (live == 0 || static_cast<float>(before - live) > _stepShare * static_cast<float>(before))
                orderAnew(block, walk, slots);
        }
    }

private:
    /// Closes the holes of a block by cycles.
    void orderAnew(std::uint32_t block, const LevelWalk& walk, SlotTable& slots)
    {
        const SlotBlock& b = slots.blocks()[block];
        GreedyPlaces places;
        std::vector<std::uint32_t> faces;
        for (std::uint32_t i = 0; i < b.extent; ++i)
        {
            const std::uint32_t face = slots.faceAt(b.first + i);
            places.isTouched.push_back(face == SlotTable::kNone || _isWritten[b.first + i]);
            if (face == SlotTable::kNone) continue;
            faces.push_back(face);
            places.positionOf.push_back(i);
        }
        std::fill_n(_isWritten.begin() + b.first, b.extent, false);
        slots.permute(block, ordered(walk, faces, _rules, std::move(places)));
        _orderedAt[block] = b.live;
    }

    std::vector<std::uint32_t> ordered(const LevelWalk& walk, const std::vector<std::uint32_t>& faces,
                                       const GreedyRules& rules, GreedyPlaces places)
    {
        return _numbers->ordered(walk, faces,
                                 [&](std::span<const Triangle> triangles, std::uint32_t wedges)
                                 { return greedyOrder(triangles, wedges, rules, std::move(places)); });
    }

    float _stepShare;
    GreedyRules _first, _rules; ///< for the finest level, and for later orderings
    std::unique_ptr<LocalNumbers> _numbers;
    std::vector<std::uint32_t> _orderedAt; ///< by block: number of faces when it was last ordered
    std::vector<bool> _isWritten;          ///< by slot: whether steps have patched its face since then
};

} // namespace

std::unique_ptr<FaceArrangement> tswapArrangement(const ArrangementSettings& settings)
{
    return std::make_unique<TswapArrangement>(settings);
}

} // namespace osgPMObjects::core
