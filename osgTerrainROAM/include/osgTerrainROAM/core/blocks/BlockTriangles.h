// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <osgTerrainROAM/core/blocks/BlockGrid.h>

namespace osgTerrainROAM::core
{

/// How a block is drawn: its level, and the levels of its four borders, none of them less. Level k keeps
/// every 2^k-th row and column; a border's level is that of the coarser of the two blocks.
struct BlockShape
{
    int level = 0;
    std::array<int, kSides> borders{};

    friend bool operator==(const BlockShape&, const BlockShape&) = default;
};

/// A triangle of a block by points of the block: (0, 0) is its south-western corner.
using BlockTriangle = std::array<GridPoint, 3>;

/// The triangles of one level of a block, without the strips along its borders. Cells of two by two squares
/// have their diagonals from the middle to the corners; so every triangle of a level lies in one of the next,
/// and all are triangles of the bintree. The coarsest level is two triangles. `origin`: of the block, which
/// tells the direction of that level's diagonal.
std::vector<BlockTriangle> innerTriangles(int exponent, int level, GridPoint origin);

/// The triangles of the strip of one square along a border: fans around the vertices that the border has.
/// They leave out the vertices of the block that a coarser neighbour lacks. Where the border's level is that
/// of the block, the strip is as inside. Precondition: level < exponent, level ≤ border ≤ exponent.
std::vector<BlockTriangle> borderTriangles(int exponent, int level, int side, int border);

/// All triangles of a shape, and their number.
std::vector<BlockTriangle> trianglesOf(int exponent, const BlockShape& shape, GridPoint origin);
std::uint32_t triangleCount(int exponent, const BlockShape& shape);

} // namespace osgTerrainROAM::core
