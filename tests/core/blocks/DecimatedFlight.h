// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgTerrainROAM/core/blocks/DecimatedMesh.h>

#include "BlockMeshCheck.h"

namespace osgTerrainROAM::core
{

/// Spoils measured errors: tests prove with it that a bound which is too small is found.
struct BlockErrorsMutation
{
    static void scale(BlockErrors& errors, float factor)
    {
        for (auto* metres : {&errors._blocksM, &errors._stripsM, &errors._morphedM})
            for (float& m : *metres)
                m *= factor;
    }

    /// Lets every border with a coarser neighbour pass for exact.
    static void forgetStrips(BlockErrors& errors)
    {
        for (float& m : errors._stripsM)
            m = 0.0f;
    }
};

} // namespace osgTerrainROAM::core
