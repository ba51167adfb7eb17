// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/GridTriangle.h>

namespace osgTerrainROAM::core
{

/// The samples of a tile's sheets against planes of triangles. Keeps all their positions: 24 B a sample, for as long as it is there.
class SheetErrors
{
public:
    explicit SheetErrors(const PlacedTile& tile);

    /// Of the samples in a triangle, its borders included; 0 where there are none.
    double largestM(const GridTriangle& t) const;

private:
    const PlacedTile& _tile;
    std::vector<std::vector<glm::dvec3>> _positions; ///< of the samples inside each sheet, row by row
};

} // namespace osgTerrainROAM::core
