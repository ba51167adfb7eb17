// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <viewlod/Frustum.h>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/GridTriangle.h>
#include <osgTerrainROAM/core/roam/Horizon.h>

namespace osgTerrainROAM::core
{

/// The hierarchy for culling: bounding spheres of the bintree's nodes down to the region level.
/// The sphere of a node holds every sample of its triangle, and so every refinement of it. It is fitted to
/// the samples: the nested radii of ErrorTree, which are for refinement, are up to twice as large.
/// Threads: immutable after fit() or setSpheres(). Memory: 40 B per node above the region level.
class RegionBounds
{
public:
    static constexpr int kRegionLevel = 9; ///< 2·2^9 regions, unless the tile has fewer levels

    /// The nodes of a tile, whose spheres hold nothing yet: fit() or setSpheres() comes next.
    explicit RegionBounds(const PlacedTile& tile);

    /// Fits the spheres to the samples. Cost: two visits per sample.
    void fit(const PlacedTile& tile);

    int level() const { return _level; } ///< of the nodes that are regions
    std::uint32_t regionCount() const { return 2u << _level; }

    /// Widens the spheres of the nodes that hold a point of the data to hold its present position.
    void include(const PlacedTile& tile, GridPoint place);

    /// The region (path at the region level) that holds a point which is on no region's border.
    /// Units: quarters of samples.
    std::uint32_t pathAt(GridPoint quarters) const { return _paths[cellQuarter(quarters)]; }

    /// Appends the regions (paths at the region level) that may be visible. Plane masks are inherited: a
    /// plane that has a node inside is not tested again below it. With a horizon, regions wholly below it are
    /// omitted.
    void visible(const viewlod::Frustum& frustum, const Horizon* horizon,
                 std::vector<std::uint32_t>& regions) const;

    glm::dvec3 centre(std::uint32_t region) const { return sphere(_level, region).centre; }

    struct Sphere
    {
        glm::dvec3 centre;
        double radiusM;
        double highestM; ///< of the samples, above the ellipsoid, or more
    };

    /// The spheres of all nodes, level by level, to be kept and put back in a tile of the same data.
    std::span<const Sphere> spheres() const { return _spheres; }
    void setSpheres(std::span<const Sphere> spheres) { _spheres.assign(spheres.begin(), spheres.end()); }

private:
    Sphere& sphere(int level, std::uint32_t path) { return _spheres[(2u << level) - 2u + path]; }
    const Sphere& sphere(int level, std::uint32_t path) const { return _spheres[(2u << level) - 2u + path]; }
    /// The index of the region at a point: at the odd region level four triangles meet in the middle of a
    /// square.
    std::size_t cellQuarter(GridPoint quarters) const
    {
        const int column = quarters.column >> _cellShift, row = quarters.row >> _cellShift;
        const int half = 1 << _cellShift >> 1;
        const int east = quarters.column - (column << _cellShift) - half;
        const int north = quarters.row - (row << _cellShift) - half;
        const int side = std::abs(east) > std::abs(north) ? (east > 0 ? 0 : 2) : (north > 0 ? 1 : 3);
        return (static_cast<std::size_t>(row) << ((_level - 1) / 2 + 2)) +
               static_cast<std::size_t>(4 * column + side);
    }

    void number(const GridTriangle& triangle, int level, std::uint32_t path);
    void fit(const PlacedTile& tile, const GridTriangle& triangle, int level, std::uint32_t path);
    void include(const GridTriangle& triangle, int level, std::uint32_t path, GridPoint place,
                 const glm::dvec3& position, double heightM);
    /// The frustum of one camera, and the regions found in it.
    struct Search
    {
        const viewlod::Frustum& frustum;
        std::vector<std::uint32_t>& regions;
    };
    /// `horizon`: null where it hides nothing.
    void visit(Search& search, int level, std::uint32_t path, viewlod::Frustum::Mask mask,
               const Horizon* horizon) const;

    int _level;
    double _geoidM; ///< highest over the ellipsoid
    /// log2 of the side, in quarters of samples, of a square that its diagonals cut into four regions
    int _cellShift;
    std::vector<std::uint16_t>
        _paths; ///< of those squares, row by row, east, north, west and south of their middles
    std::vector<Sphere> _spheres; ///< level by level, two nodes at level 0
};

} // namespace osgTerrainROAM::core
