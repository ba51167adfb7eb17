// SPDX-License-Identifier: Apache-2.0
#include <osgTerrainROAM/core/roam/TerrainMesh.h>

namespace osgTerrainROAM::core
{

std::vector<IndexRange> TerrainMesh::allRanges() const
{
    std::vector<IndexRange> ranges;
    visibleRanges(viewlod::Frustum(glm::dmat4(0.0)), ranges); // planes without direction cull nothing
    return ranges;
}

} // namespace osgTerrainROAM::core
