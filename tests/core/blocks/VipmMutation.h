// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include <osgTerrainROAM/core/blocks/VipmBlocks.h>

namespace osgTerrainROAM::core
{

/// Spoils prepared blocks: tests prove with it that the check finds what is wrong.
struct VipmMutation
{
    static std::shared_ptr<VipmBlocks> copyOf(const VipmBlocks& blocks)
    {
        return std::make_shared<VipmBlocks>(blocks);
    }

    static void scaleErrors(VipmBlocks& blocks, float factor)
    {
        for (auto& block : blocks._blocks)
        {
            auto changed = std::make_shared<VipmBlock>(*block);
            for (VipmLevel& level : changed->levels)
                level.errorM *= factor;
            block = changed;
        }
    }

    static void unlock(VipmBlocks& blocks)
    {
        for (std::uint32_t block = 0; block < blocks.grid().count(); ++block)
            blocks._blocks[block] = std::make_shared<const VipmBlock>(
                makeVipmBlock(blocks.tile().tile, blocks.grid(), block, std::nullopt));
    }
};

} // namespace osgTerrainROAM::core
