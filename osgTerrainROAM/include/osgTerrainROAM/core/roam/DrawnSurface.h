// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

/// The drawn mesh of any method, for queries: what is drawn at a place, and how far that is from the truth.
/// drawnGroundAt() answers for ROAM's tree without making anything.
/// Frame: the tile's. Units: metres. Memory: the mesh, and 4 B for each triangle and square of 16 cells that
/// it touches. Cost of making: linear in the triangles. Threads: const from any.
class DrawnSurface
{
public:
    /// `tile` must stay.
    DrawnSurface(const PlacedTile& tile, DrawnMesh mesh);

    struct Ground
    {
        glm::dvec3 position; ///< on the drawn triangle
        glm::dvec3 normal;   ///< of that triangle, unit length, pointing up
        double boundM;       ///< largest distance of a sample in that triangle from where it is drawn
        LeafTriangle triangle;
    };

    /// Finds the surface vertically above or below a place; of parts that overlap, the uppermost. Nothing
    /// beyond the edge of the data.
    /// Cost: the triangles of a square of 16 cells, and the samples in the one that is found.
    std::optional<Ground> at(double eastM, double northM) const;

private:
    struct Found
    {
        std::uint32_t triangle;
        glm::dvec3 position, normal;
    };

    std::optional<Found> uppermost(const glm::dvec2& place) const;
    double boundM(std::uint32_t triangle) const;
    int column(double eastM) const;
    int row(double northM) const;

    const PlacedTile& _tile;
    DrawnMesh _mesh;
    glm::dvec2 _corner{0.0}, _squareM{1.0};
    int _columns = 1, _rows = 1;
    std::vector<std::vector<std::uint32_t>> _squares; ///< triangles that touch each, row by row
};

} // namespace osgTerrainROAM::core
