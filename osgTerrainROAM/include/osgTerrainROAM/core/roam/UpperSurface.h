// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

/// The uppermost drawn point at each sample of the raster: what an eye above the ground sees of a mesh whose
/// parts overlap.
/// Frame: the tile's. Units: metres. Memory: 24 B a sample. Cost: one visit per sample and triangle that
/// covers it.
class UpperSurface
{
public:
    UpperSurface(const PlacedTile& tile, const DrawnMesh& mesh);

    int columns() const { return _columns; }
    int rows() const { return _rows; }

    /// Whether a triangle covers a sample of the raster, by its column and row there.
    bool covers(int column, int row) const { return point(column, row).z > kUncovered; }

    /// The uppermost point there. Precondition: covers().
    const glm::dvec3& point(int column, int row) const
    {
        return _points[static_cast<std::size_t>(row) * static_cast<std::size_t>(_columns) +
                       static_cast<std::size_t>(column)];
    }

private:
    static constexpr double kUncovered = -1e300;

    int _columns, _rows;
    std::vector<glm::dvec3> _points; ///< row by row
};

} // namespace osgTerrainROAM::core
