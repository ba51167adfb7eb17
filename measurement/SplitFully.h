// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include <osgTerrainROAM/core/roam/DiamondTree.h>

namespace measurement
{

/// Splits the given triangles and all triangles below them to the finest level.
inline void splitFully(osgTerrainROAM::core::DiamondTree& tree,
                       std::vector<osgTerrainROAM::core::TriangleId> open = {
                           osgTerrainROAM::core::DiamondTree::kRoots[0],
                           osgTerrainROAM::core::DiamondTree::kRoots[1]})
{
    while (!open.empty())
    {
        const osgTerrainROAM::core::TriangleId t = open.back();
        open.pop_back();
        if (tree.canSplit(t)) tree.forceSplit(t);
        if (tree.isLeaf(t)) continue;
        for (const osgTerrainROAM::core::TriangleId child : tree.children(t))
            open.push_back(child);
    }
}

} // namespace measurement
