// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osg/BoundingBox>

#include "../view/MeshPacket.h"
#include "OuterAxis.h"
#include "OuterGround.h"

namespace osgTerrainROAM
{

/// The triangles of the surroundings. Their inner edge has every sample on the border of the data; a wall
/// below it closes the gap to the drawn tile, which may be off by its error. Vertices are counted in steps of
/// kStepM.
struct OuterMesh
{
    static constexpr double kStepM = 1.0 / 2048.0; ///< 31 bits of them are 1000 km

    /// Triangles that are culled together.
    struct Block
    {
        core::IndexRange triangles;
        osg::BoundingBox box;
    };

    MeshPacket packet; ///< whole
    std::vector<Block> blocks;
};

/// Makes the mesh: a grid on every fourth texel of the axes, denser near the border. Cost: some 10 ms.
OuterMesh outerMesh(const OuterGround& ground, const OuterAxis& columns, const OuterAxis& rows);

} // namespace osgTerrainROAM
