// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgMultiTriangulation/core/structure/MultiTriangulation.h>

namespace osgMultiTriangulation::core
{

/// A tree of a split multi-triangulation: a part of the surface that can be loaded by itself once its parent
/// is there. The triangles of its root are triangles of its parent's drain.
struct ForestTree
{
    MultiTriangulation part;
    std::uint32_t parent = kNone; ///< number of a tree, less than its own; kNone for the main part
    std::vector<std::uint32_t> parentTriangles; ///< by triangle of the root: its number in the parent

    bool operator==(const ForestTree&) const = default;
};

/// A split multi-triangulation: the main part, tree 0, and the trees below it. Its drain is the whole
/// surface: the drains of all trees, without the triangles that are a child's root.
struct Forest
{
    std::vector<ForestTree> trees; ///< parents before children
};

} // namespace osgMultiTriangulation::core
