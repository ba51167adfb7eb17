// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/GridTriangle.h>

namespace osgTerrainROAM::core
{

/// Measures the samples of a tile's sheets against the planes of triangles. It stores all their positions
/// while it exists: 24 B a sample.
class SheetErrors
{
public:
    explicit SheetErrors(const PlacedTile& tile);

    /// Returns the error of the samples in a triangle, its borders included; 0 where there are none.
    double largestM(const GridTriangle& t) const;

private:
    const PlacedTile& _tile;
    std::vector<std::vector<glm::dvec3>> _positions; ///< of the samples inside each sheet, row by row
};

} // namespace osgTerrainROAM::core
