// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/core/order/TriangleOrders.h>

#include "FaceArrangement.h"

namespace osgPMObjects::core
{

namespace
{

/// Implements Arrangement::blocks.
class BlockArrangement : public FaceArrangement
{
public:
    explicit BlockArrangement(std::uint32_t blockFaces) : _blockFaces(blockFaces) {}

    void begin(const LevelWalk& walk, SlotTable& slots) override
    {
        _numbers = std::make_unique<LocalNumbers>(walk);
        std::uint32_t material = 0;
        for (const std::vector<std::uint32_t>& faces : liveFacesByMaterial(walk))
            slots.append(material++, _numbers->ordered(walk, faces, libraryOrder), _blockFaces);
    }

    void afterStep(const LevelWalk& walk, SlotTable& slots) override
    {
        const std::vector<std::uint32_t> touched = slots.blocksWithRemovals();
        for (const std::uint32_t block : touched)
            slots.fillHoles(block);
        for (const std::uint32_t block : touched)
            for (const std::uint32_t other : {slots.liveNeighbour(block, -1), slots.liveNeighbour(block, +1)})
                if (other != SlotTable::kNone &&
                    fitsIn(slots, std::min(block, other), std::max(block, other)))
                {
                    merge(walk, slots, std::min(block, other), std::max(block, other));
                    break;
                }
    }

private:
    static bool fitsIn(const SlotTable& slots, std::uint32_t first, std::uint32_t second)
    {
        return slots.blocks()[first].live > 0 && slots.blocks()[second].live > 0 &&
               slots.blocks()[first].live + slots.blocks()[second].live <= slots.blocks()[first].capacity;
    }

    void merge(const LevelWalk& walk, SlotTable& slots, std::uint32_t first, std::uint32_t second)
    {
        std::vector<std::uint32_t> faces;
        slots.appendFaces(first, faces);
        slots.appendFaces(second, faces);
        slots.rewrite({first, second}, _numbers->ordered(walk, faces, libraryOrder));
    }

    std::uint32_t _blockFaces;
    std::unique_ptr<LocalNumbers> _numbers;
};

} // namespace

std::unique_ptr<FaceArrangement> blockArrangement(const ArrangementSettings& settings)
{
    constexpr std::uint32_t kBlockFaces = 32;
    return std::make_unique<BlockArrangement>(settings.blockFaces == 0 ? kBlockFaces : settings.blockFaces);
}

} // namespace osgPMObjects::core
