// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cassert>

#include <osgTerrainROAM/core/heightfield/GeodeticLattice.h>

#include "LocalFrame.h"

namespace osgTerrainROAM::core
{

GeodeticLattice::GeodeticLattice(const TileGrid& grid, const GeodeticNet& net,
                                 const std::optional<Geodetic>& origin)
    : _exponent(grid.exponent()),
      _step(net.step << grid.exponent()),
      _side(net.nodesPerSide),
      _cellShift(std::bit_width(static_cast<unsigned>(_step)))
{
    assert(net.step > 0 && std::has_single_bit(static_cast<unsigned>(net.step)));
    assert(_side == ((grid.side() - 1) >> _exponent) / net.step + 1 && _side % 2 == 1);
    _weights.reserve(2 * static_cast<std::size_t>(net.step) + 1);
    for (int offset = 0; offset <= 2 * net.step; ++offset)
        _weights.push_back(weightsAt(static_cast<double>(offset) / net.step));
    _origin = origin ? *origin : centreOf(grid, net);
    fillNodes(net);
}

/// Finds the middle of the data on the ellipsoid. Interpolates geocentric positions: unlike longitudes they
/// are continuous everywhere.
Geodetic GeodeticLattice::centreOf(const TileGrid& grid, const GeodeticNet& net) const
{
    const auto& earth = GeographicLib::Geocentric::WGS84();
    const CellLocation middle = locate(0.5 * (grid.dataColumns() - 1), 0.5 * (grid.dataRows() - 1));
    const Weights wx = weightsAt(middle.east);
    const Weights wy = weightsAt(middle.north);
    glm::dvec3 centre(0.0);
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
        {
            const GeodeticNet::Node& node = net.node(2 * middle.cellColumn + i, 2 * middle.cellRow + j);
            glm::dvec3 p;
            earth.Forward(node.latitudeDeg, node.longitudeDeg, 0.0, p.x, p.y, p.z);
            centre += wx.w[i] * wy.w[j] * p;
        }
    Geodetic result;
    earth.Reverse(centre.x, centre.y, centre.z, result.latitudeDeg, result.longitudeDeg, result.heightM);
    result.heightM = 0.0;
    return result;
}

void GeodeticLattice::fillNodes(const GeodeticNet& net)
{
    const GeographicLib::LocalCartesian frame = localFrameAt(_origin);
    _nodes.reserve(net.nodes.size());
    std::vector<double> rotation(9); // row-major, local from the node's own east-north-up
    for (const GeodeticNet::Node& node : net.nodes)
    {
        glm::dvec3 base;
        frame.Forward(node.latitudeDeg, node.longitudeDeg, node.geoidM, base.x, base.y, base.z, rotation);
        _nodes.emplace_back(base, glm::dvec3(rotation[2], rotation[5], rotation[8]));
    }
}

GeodeticLattice::Weights GeodeticLattice::weightsAt(double t)
{
    return {{0.5 * (t - 1.0) * (t - 2.0), t * (2.0 - t), 0.5 * t * (t - 1.0)}};
}

GeodeticLattice::Weights GeodeticLattice::slopesAt(double t)
{
    return {{t - 1.5, 2.0 - 2.0 * t, t - 0.5}};
}

GeodeticLattice::CellLocation GeodeticLattice::locate(double column, double row) const
{
    // Locations beyond the tile, and those that are not a number, go to a cell at its edge.
    const int last = (_side - 1) / 2 - 1;
    const auto cell = [last](double nodes) {
        return !(nodes > 0.0) ? 0 : nodes < 2.0 * last ? static_cast<int>(0.5 * nodes) : last;
    };
    const double east = column / _step;
    const double north = row / _step;
    const int a = cell(east);
    const int b = cell(north);
    return {a, b, east - 2 * a, north - 2 * b};
}

GeodeticLattice::Node GeodeticLattice::blend(int cellColumn, int cellRow, const Weights& wx,
                                             const Weights& wy) const
{
    const Node* node = &_nodes[static_cast<std::size_t>(2 * cellRow) * _side + 2 * cellColumn];
    glm::dvec3 base(0.0), up(0.0); // they stay in registers
    for (int j = 0; j < 3; ++j, node += _side)
        for (int i = 0; i < 3; ++i)
        {
            const double w = wx.w[i] * wy.w[j];
            base += w * node[i].base();
            up += w * node[i].up();
        }
    return {base, up};
}

glm::dvec3 GeodeticLattice::position(int column, int row, double heightM) const
{
    // The last point belongs to the last cell, not to one that would begin there.
    const int last = (_side - 1) / 2 - 1;
    const int a = std::min(column >> _cellShift, last);
    const int b = std::min(row >> _cellShift, last);
    const auto weights = [this](int offset)
    {
        if ((offset & ((1 << _exponent) - 1)) == 0) [[likely]]
            return _weights[static_cast<std::size_t>(offset >> _exponent)];
        return weightsAt(static_cast<double>(offset) / _step);
    };
    const Node here = blend(a, b, weights(column - (a << _cellShift)), weights(row - (b << _cellShift)));
    return here.base() + heightM * here.up();
}

glm::dvec3 GeodeticLattice::positionAt(double column, double row, double heightM) const
{
    const CellLocation at = locate(column, row);
    const Node here = blend(at.cellColumn, at.cellRow, weightsAt(at.east), weightsAt(at.north));
    return here.base() + heightM * here.up();
}

/// The unknowns are column, row and height; the height is eliminated by projecting onto `up`.
glm::dvec2 GeodeticLattice::newtonStep(const glm::dvec2& grid, const glm::dvec3& local) const
{
    const CellLocation at = locate(grid.x, grid.y);
    const Weights wx = weightsAt(at.east);
    const Weights wy = weightsAt(at.north);
    const Node here = blend(at.cellColumn, at.cellRow, wx, wy);
    const Node alongEast = blend(at.cellColumn, at.cellRow, slopesAt(at.east), wy);
    const Node alongNorth = blend(at.cellColumn, at.cellRow, wx, slopesAt(at.north));
    const double height = glm::dot(local - here.base(), here.up());
    const glm::dmat3 jacobian(alongEast.base() + height * alongEast.up(),
                              alongNorth.base() + height * alongNorth.up(), here.up());
    const glm::dvec3 residual = local - (here.base() + height * here.up());
    return glm::dvec2(glm::inverse(jacobian) * residual) * static_cast<double>(_step);
}

} // namespace osgTerrainROAM::core
