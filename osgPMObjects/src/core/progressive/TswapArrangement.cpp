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
    }

    void afterStep(const LevelWalk& walk, SlotTable& slots) override
    {
        _isTouched.resize(slots.slotCount(), false);
        for (const std::uint32_t block : slots.blocksWithRemovals())
        {
            for (const std::uint32_t slot : slots.fillHoles(block))
                _isTouched[slot] = true;
            if (_orderedAt[block] - slots.blocks()[block].live >
                _stepShare * static_cast<float>(_orderedAt[block]))
                orderAnew(block, walk, slots);
        }
    }

private:
    void orderAnew(std::uint32_t block, const LevelWalk& walk, SlotTable& slots)
    {
        const SlotBlock& b = slots.blocks()[block];
        std::vector<std::uint32_t> faces;
        slots.appendFaces(block, faces);
        const auto first = _isTouched.begin() + b.first;
        slots.rewrite({block}, ordered(walk, faces, _rules, {first, first + b.extent}));
        std::fill_n(first, b.extent, false);
        _orderedAt[block] = b.live;
    }

    std::vector<std::uint32_t> ordered(const LevelWalk& walk, const std::vector<std::uint32_t>& faces,
                                       const GreedyRules& rules, std::vector<bool> isTouched)
    {
        return _numbers->ordered(walk, faces,
                                 [&](std::span<const Triangle> triangles, std::uint32_t wedges)
                                 { return greedyOrder(triangles, wedges, rules, std::move(isTouched)); });
    }

    float _stepShare;
    GreedyRules _first, _rules; ///< for the finest level, and for later orderings
    std::unique_ptr<LocalNumbers> _numbers;
    std::vector<std::uint32_t> _orderedAt; ///< by block: number of faces when it was last ordered
    std::vector<bool> _isTouched;          ///< by slot: whether it was written since then
};

} // namespace

std::unique_ptr<FaceArrangement> tswapArrangement(const ArrangementSettings& settings)
{
    return std::make_unique<TswapArrangement>(settings);
}

} // namespace osgPMObjects::core
