// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/Geodetic.h>
#include <osgTerrainROAM/core/heightfield/HeightField.h>
#include <osgTerrainROAM/core/heightfield/TileGrid.h>

namespace osgTerrainROAM::core
{

/// A lattice of exact positions and ellipsoid normals at the nodes of a GeodeticNet, interpolated
/// biquadratically: each cell of 3 by 3 nodes has one Lagrange polynomial of degree 2 in each direction. A
/// position is a function of grid point and height alone: the same bits on every call.
/// Frame: local east-north-up metres about origin(). Heights are metres as the samples count them; the net
/// adds the geoid.
/// Memory: 48 B a node. Threads: immutable.
class GeodeticLattice
{
public:
    /// `origin`: of the local frame; absent: the centre of the data at ellipsoidal height 0.
    GeodeticLattice(const TileGrid& grid, const GeodeticNet& net, const std::optional<Geodetic>& origin);

    const Geodetic& origin() const { return _origin; }

    /// Position of a grid point. Cost: about 60 flops.
    glm::dvec3 position(int column, int row, double heightM) const;

    /// The same between grid points. Points beyond the grid are extrapolated.
    glm::dvec3 positionAt(double column, double row, double heightM) const;

    /// Computes one Newton step, in grid points, towards the solution (grid, height) of positionAt(grid,
    /// height) = local.
    glm::dvec2 newtonStep(const glm::dvec2& grid, const glm::dvec3& local) const;

private:
    /// The local position at sample height 0 and the ellipsoid's normal, side by side: interpolated two
    /// numbers at a time.
    struct Node
    {
        std::array<double, 6> values{};
        Node() = default;
        Node(const glm::dvec3& base, const glm::dvec3& up) : values{base.x, base.y, base.z, up.x, up.y, up.z}
        {
        }
        glm::dvec3 base() const { return {values[0], values[1], values[2]}; }
        glm::dvec3 up() const { return {values[3], values[4], values[5]}; }
    };

    /// Quadratic Lagrange weights of three nodes in a row, or their derivatives.
    struct Weights
    {
        double w[3];
    };

    /// A cell of 3 by 3 nodes, and a location in it: nodes east and north of its first node, 0…2.
    struct CellLocation
    {
        int cellColumn, cellRow;
        double east, north;
    };

    static Weights weightsAt(double nodesFromFirst);
    static Weights slopesAt(double nodesFromFirst);
    Geodetic centreOf(const TileGrid& grid, const GeodeticNet& net) const;
    void fillNodes(const GeodeticNet& net);
    CellLocation locate(double column, double row) const;
    Node blend(int cellColumn, int cellRow, const Weights& wx, const Weights& wy) const;

    int _exponent;                 ///< of the grid
    int _step;                     ///< grid points between nodes
    int _side;                     ///< nodes along a side, odd: whole cells of 2 by 2 steps
    int _cellShift;                ///< log2(2·step): a point's cell is index >> shift
    std::vector<Weights> _weights; ///< by raster sample within a cell
    Geodetic _origin;
    std::vector<Node> _nodes;
};

} // namespace osgTerrainROAM::core
