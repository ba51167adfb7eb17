// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <foundation/Result.h>
#include <glm/glm.hpp>

#include <osgTerrainROAM/core/features/GroundOpening.h>

namespace osgTerrainROAM::core
{

/// Openings of the ground in square cells, for a fragment shader and for queries. Each cell lists the pieces
/// of openings, straight between two cross-sections, that reach into it.
/// A piece is four texels: [east, north, up, half width] of its first and of its last section, [low, wall,
/// knee, crown] heights, and [before, beyond, 0, 0], by how much it goes on at its ends. East and north count
/// from the middle of the cell.
/// Frame: the tile's local east, north and up. Units: metres. Cells are counted from the frame's origin.
/// Memory: 16 B a cell, 512 by 512 of them at most, and 64 B a piece in each of its cells. Threads: immutable
/// after build().
struct OpeningCells
{
    static constexpr int kTexelsOfPiece = 4;

    struct Cell
    {
        std::uint32_t first = 0, pieces = 0; ///< the first texel of its list
    };

    double cellM = 32.0; ///< a power of two, up to 4096
    glm::ivec2 firstCell{0};
    int columns = 0, rows = 0;
    std::vector<Cell> cells; ///< row-major, southernmost first
    std::vector<std::array<float, 4>> records;

    bool isEmpty() const { return records.empty(); }

    /// Returns whether a place lies in an opening. Cost: a tenth of a microsecond beside openings, less than
    /// one in them.
    bool isOpen(const glm::dvec3& place) const;

    /// Errors: an opening with less than two sections, or with places that are not finite or more than 1000
    /// km apart.
    static foundation::Result<OpeningCells> build(const std::vector<GroundOpening>& openings);
};

} // namespace osgTerrainROAM::core
