// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/PlanTriangle.h>

namespace osgTerrainROAM::core
{

/// Measures triangles against all samples of the data in a rectangle of the grid. It stores the positions of
/// the raster's samples there while it exists: 24 B each.
class SurfaceError
{
public:
    SurfaceError(const PlacedTile& tile, const GridRect& around);

    /// The largest distance of a sample in the triangle, its border included, from the point of the surface
    /// at its place. `corners`: where the triangle's corners are drawn; they need not lie on their samples.
    /// Samples outside the rectangle are not seen; 0 where there are none. Units: metres.
    double largestM(const PlanTriangle& triangle, const std::array<glm::dvec3, 3>& corners) const;

private:
    const PlacedTile& _tile;
    GridRect _around;
    int _step, _perRow;
    std::vector<glm::dvec3>
        _positions; ///< of the raster's samples, row by row; kNoSample where there is none
};

} // namespace osgTerrainROAM::core
