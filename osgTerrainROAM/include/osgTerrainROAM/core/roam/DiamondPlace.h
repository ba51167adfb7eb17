// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <osgTerrainROAM/core/roam/GridTriangle.h>

namespace osgTerrainROAM::core
{

namespace detail
{

/// The eight directions, counter-clockwise from east.
inline constexpr int kColumnStep[8] = {1, 1, 0, -1, -1, -1, 0, 1};
inline constexpr int kRowStep[8] = {0, 1, 1, 1, 0, -1, -1, -1};

constexpr unsigned next(unsigned quadrant)
{
    return (quadrant + 1u) & 3u;
}

constexpr unsigned previous(unsigned quadrant)
{
    return (quadrant + 3u) & 3u;
}

/// Which of the corners 0 and 2 (the parents) is an end of the outer edge of a quadrant.
constexpr unsigned parentOnEdge(unsigned quadrant)
{
    return (quadrant + 1u) & 2u;
}

} // namespace detail

/// The position of a vertex in the grid and in the bintree, packed into 8 bytes.
struct DiamondPlace
{
    static constexpr unsigned kFree = 0x80; ///< bit of `direction`: no vertex has this slot
    static constexpr unsigned kLostBoth =
        0x40; ///< bit of `direction`: one enhMerge removed both of its parents

    std::uint32_t column : 22 = 0;
    std::uint32_t firstQuadrant : 2 = 0; ///< of corner 0, which the vertex split
    std::int32_t level : 8 = -1;         ///< of the triangles that the vertex split; -1: a corner of the tile
    std::uint32_t row : 22 = 0;
    std::uint32_t secondQuadrant : 2 = 0; ///< of corner 2
    std::uint32_t direction : 8 =
        kFree; ///< of the diamond's first corner: 0 east, 1 north-east … 7 south-east

    bool isFree() const { return (direction & kFree) != 0; }
    GridPoint point() const { return {static_cast<int>(column), static_cast<int>(row)}; }

    /// The quadrant of corner 0 or 2 that the vertex split.
    unsigned parentQuadrant(unsigned corner) const { return corner == 0 ? firstQuadrant : secondQuadrant; }
};
static_assert(sizeof(DiamondPlace) == 8);

} // namespace osgTerrainROAM::core
