// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/vdpm/BoundedForest.h>

namespace osgTerrainROAM::core
{

/// Prepares the raster of a tile as a view-dependent progressive mesh: collapses by exact error
/// (osgMultiTriangulation's collapseOrder()), the forest, and bounds that are measured at every sample of
/// every triangle that there was, in 3D, as ErrorTree measures those of the bintree; those of triangles that
/// sides sweep while a vertex moves count, too. The numbers in VertexForest::original are raster indices, row
/// by row.
/// Errors: a raster with holes, with denser parts or with edited samples. Cost: about 15 µs a sample, near
/// linear.
/// Memory: about 500 B a sample while it works.
foundation::Result<BoundedForest> heightFieldForest(const PlacedTile& tile);

} // namespace osgTerrainROAM::core
