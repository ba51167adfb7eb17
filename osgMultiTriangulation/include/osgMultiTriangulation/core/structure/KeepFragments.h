// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgMultiTriangulation/core/structure/MultiTriangulation.h>

namespace osgMultiTriangulation::core
{

/// Takes the last fragments from a multi-triangulation, so that the first `count` are left: their triangles
/// are again those of the drain where what lay below them is gone. Its memory is not given back.
/// Source: *Multi-Triangulation as applied to very large terrains visualization* (Graphicon 2005), section 5:
/// the lower link of the triangles in the floors of unloaded fragments points to the drain.
void keepFragments(MultiTriangulation& tree, std::size_t count);

/// Gives the memory back that a multi-triangulation does not need.
void releaseMemory(MultiTriangulation& tree);

} // namespace osgMultiTriangulation::core
