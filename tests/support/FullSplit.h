// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include <osgTerrainROAM/core/roam/BinTriangleTree.h>

namespace testsupport
{

/// Splits everything below the given triangles to the finest level.
inline void splitFully(osgTerrainROAM::core::BinTriangleTree& tree,
                       std::vector<osgTerrainROAM::core::NodeIndex> open = {0, 1})
{
    while (!open.empty())
    {
        const osgTerrainROAM::core::NodeIndex t = open.back();
        open.pop_back();
        if (tree.canSplit(t)) tree.forceSplit(t);
        if (!tree.node(t).isLeaf())
            open.insert(open.end(), {tree.node(t).firstChild, tree.node(t).firstChild + 1});
    }
}

} // namespace testsupport
