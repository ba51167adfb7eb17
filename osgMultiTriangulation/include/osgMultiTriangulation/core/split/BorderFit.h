// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgMultiTriangulation/core/split/Partition.h>
#include <osgMultiTriangulation/core/split/TreeCount.h>
#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// Fits c of the border model to a surface: the points are divided as the model so far asks for, and those of
/// triangles that reach over a border are counted; three rounds. A surface in one rectangle has no border;
/// its model is that without a fit.
/// Cost: about that of three partitions. Memory: 4 B a point.
/// Source: *Multi-Triangulation as applied to very large terrains visualization* (Graphicon 2005), section 3:
/// c depends on the distribution of the points and is found by experiment. Differs: on the input itself.
BorderModel fitBorder(const SurfaceMesh& mesh, SplitAt where = SplitAt::centre);

} // namespace osgMultiTriangulation::core
