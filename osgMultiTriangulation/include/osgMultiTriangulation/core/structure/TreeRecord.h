// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgMultiTriangulation/core/structure/MultiTriangulation.h>

namespace osgMultiTriangulation::core
{

/// A tree with its ties to the trees below it.
struct TreeRecord
{
    MultiTriangulation part;
    std::vector<std::vector<std::uint32_t>>
        childRoots; ///< for each tree below it: the triangles of its root, as numbers here

    bool operator==(const TreeRecord&) const = default;
};

} // namespace osgMultiTriangulation::core
