// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include <osgTerrainROAM/core/roam/DiamondTree.h>

#include "SyntheticField.h"

namespace testsupport
{

using osgTerrainROAM::core::DiamondTree;
using osgTerrainROAM::core::GridTriangle;
using osgTerrainROAM::core::TriangleId;

/// A leaf, or (`stopOneIn`: on the way with that chance) a split triangle, on a random way down.
inline TriangleId randomDescent(const DiamondTree& tree, Random& random, unsigned stopOneIn = 0)
{
    TriangleId t = DiamondTree::kRoots[random.below(2)];
    while (!tree.isLeaf(t) && (stopOneIn == 0 || random.below(stopOneIn) != 0))
        t = tree.children(t)[random.below(2)];
    return t;
}

/// A vertex that the tree has split, on a random way down; kNone when there is none.
inline osgTerrainROAM::core::VertexSlot randomVertex(const DiamondTree& tree, Random& random,
                                                     unsigned stopOneIn)
{
    const TriangleId t = randomDescent(tree, random, stopOneIn);
    if (!tree.isLeaf(t)) return tree.splitVertex(t);
    return t.apex() < DiamondTree::kCorners ? osgTerrainROAM::core::kNone : t.apex();
}

using CornerIndices = std::array<int, 6>; ///< column and row of apex, left, right

inline CornerIndices cornersOf(const GridTriangle& t)
{
    return {t.apex.column, t.apex.row, t.left.column, t.left.row, t.right.column, t.right.row};
}

/// All leaves, drawn or not, in the order of their corners: equal for equal meshes.
inline std::vector<CornerIndices> leafSet(const DiamondTree& tree)
{
    std::vector<CornerIndices> leaves;
    std::vector<TriangleId> open(std::begin(DiamondTree::kRoots), std::end(DiamondTree::kRoots));
    while (!open.empty())
    {
        const TriangleId t = open.back();
        open.pop_back();
        if (tree.isLeaf(t))
            leaves.push_back(cornersOf(tree.gridTriangle(t)));
        else
            for (const TriangleId child : tree.children(t))
                open.push_back(child);
    }
    std::sort(leaves.begin(), leaves.end());
    return leaves;
}

inline std::vector<CornerIndices> leafSet(const std::vector<GridTriangle>& triangles)
{
    std::vector<CornerIndices> leaves;
    std::transform(triangles.begin(), triangles.end(), std::back_inserter(leaves), cornersOf);
    std::sort(leaves.begin(), leaves.end());
    return leaves;
}

} // namespace testsupport
