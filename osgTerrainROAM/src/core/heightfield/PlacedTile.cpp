// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <utility>

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

namespace
{

GeographicLib::LocalCartesian frameAt(const Geodetic& origin)
{
    return {origin.latitudeDeg, origin.longitudeDeg, origin.heightM, GeographicLib::Geocentric::WGS84()};
}

HeightField complete(HeightField field)
{
    assert(field.isComplete());
    return field;
}

/// As fine as edits and the densest part need.
int gridExponentOf(const HeightField& field, int wanted)
{
    for (const DensePart& part : field.parts)
        wanted = std::max(wanted, part.exponent);
    return wanted;
}

} // namespace

PlacedTile::PlacedTile(HeightField field, const PlacedTileOptions& options)
    : _field(complete(std::move(field))),
      _samples(std::exchange(_field.heightsM, {}), options.storage,
               gridExponentOf(_field, options.gridExponent) > 0 ? kEditHeadroom : 1.0),
      _placement(_field.net ? options.placement : Placement::planar),
      _gridExponent(gridExponentOf(_field, options.gridExponent)),
      _betweenSamples((1 << _gridExponent) - 1)
{
    initSide();
    laySheets(std::move(_field.parts), options.storage);
    if (_placement == Placement::curved)
    {
        initLatticePlaces();
        _origin = options.origin ? *options.origin : dataCentre();
        buildLattice();
    }
    initRadiusRange();
    initVertexStep();
}

void PlacedTile::initSide()
{
    _side = ((_field.tileSide() - 1) << _gridExponent) + 1;
    assert(_gridExponent >= 0 && _side <= kMostSide);
    _levels = 2 * (std::bit_width(static_cast<unsigned>(_side - 1)) - 1);
    _dataColumns = ((_field.columns - 1) << _gridExponent) + 1;
    _dataRows = ((_field.rows - 1) << _gridExponent) + 1;
    _placeEastM = std::ldexp(_field.spacingEastM, -_gridExponent);
    _placeNorthM = std::ldexp(_field.spacingNorthM, -_gridExponent);
}

void PlacedTile::initLatticePlaces()
{
    const GeodeticNet& net = *_field.net;
    assert(net.step > 0 && std::has_single_bit(static_cast<unsigned>(net.step)));
    assert(net.nodesPerSide == ((_side - 1) >> _gridExponent) / net.step + 1 && net.nodesPerSide % 2 == 1);
    _latticeStep = net.step << _gridExponent;
    _latticeSide = net.nodesPerSide;
    _macroShift = std::bit_width(static_cast<unsigned>(_latticeStep));
    _weights.reserve(2 * static_cast<std::size_t>(net.step) + 1);
    for (int offset = 0; offset <= 2 * net.step; ++offset)
        _weights.push_back(weightsAt(static_cast<double>(offset) / net.step));
}

void PlacedTile::initRadiusRange()
{
    const double last = _side - 1;
    const double acrossM = std::max(glm::distance(positionAt(0, 0, 0.0), positionAt(last, last, 0.0)),
                                    glm::distance(positionAt(last, 0, 0.0), positionAt(0, last, 0.0)));
    double heightsM = _samples.heightRangeM();
    for (const SampleSheet& sheet : _sheets)
        heightsM = std::max(heightsM, sheet.table().heightRangeM());
    const double mostM = 8.0 * (acrossM + heightsM);
    _samples.setRadiusRange(acrossM / ((_side - 1) >> _gridExponent) / 16.0, mostM);
    for (SampleSheet& sheet : _sheets)
        sheet.table().setRadiusRange(acrossM / (_side - 1) / 16.0, mostM);
}

void PlacedTile::initVertexStep()
{
    constexpr double kBeyondM = 20000.0; // higher than any land, or displaced by morphing
    const double last = _side - 1;
    double farthestM = 0.0;
    for (const double column : {0.0, 0.5 * last, last})
        for (const double row : {0.0, 0.5 * last, last})
            for (int axis = 0; axis < 3; ++axis)
                farthestM = std::max(farthestM, std::abs(positionAt(column, row, 0.0)[axis]));
    _vertexStepM = std::exp2(std::ceil(std::log2(1.1 * farthestM + kBeyondM)) - 30.0);
}

/// The middle of the samples, on the ellipsoid. Interpolated between geocentric positions, which unlike
/// longitudes are continuous everywhere.
Geodetic PlacedTile::dataCentre() const
{
    const auto& earth = GeographicLib::Geocentric::WGS84();
    const GeodeticNet& net = *_field.net;
    const LatticePlace place = latticePlace(0.5 * (_dataColumns - 1), 0.5 * (_dataRows - 1));
    const Weights wx = weightsAt(place.east);
    const Weights wy = weightsAt(place.north);
    glm::dvec3 centre(0.0);
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i)
        {
            const GeodeticNet::Node& node = net.node(2 * place.macroColumn + i, 2 * place.macroRow + j);
            glm::dvec3 p;
            earth.Forward(node.latitudeDeg, node.longitudeDeg, 0.0, p.x, p.y, p.z);
            centre += wx.w[i] * wy.w[j] * p;
        }
    Geodetic result;
    earth.Reverse(centre.x, centre.y, centre.z, result.latitudeDeg, result.longitudeDeg, result.heightM);
    result.heightM = 0.0;
    return result;
}

void PlacedTile::buildLattice()
{
    const GeographicLib::LocalCartesian frame = frameAt(_origin);
    _lattice.reserve(_field.net->nodes.size());
    std::vector<double> rotation(9); // row-major, local from the node's own east-north-up
    for (const GeodeticNet::Node& node : _field.net->nodes)
    {
        glm::dvec3 base;
        frame.Forward(node.latitudeDeg, node.longitudeDeg, node.geoidM, base.x, base.y, base.z, rotation);
        _lattice.emplace_back(base, glm::dvec3(rotation[2], rotation[5], rotation[8]));
    }
    drawSketch();
}

void PlacedTile::drawSketch()
{
    const double d = 0.5 * (_side - 1);
    const double heightM = this->heightM(_side / 2, _side / 2);
    const auto at = [&](int east, int north)
    { return glm::dvec2(positionAt(d + east * d, d + north * d, heightM)); };
    const glm::dvec2 west = at(-1, 0), east = at(1, 0), south = at(0, -1), north = at(0, 1);
    _sketch.grid = glm::dvec2(d);
    _sketch.local = at(0, 0);
    _sketch.inverse = glm::inverse(glm::dmat2(east - west, north - south) / (2.0 * d));
    _sketch.xx = (east + west - 2.0 * _sketch.local) / (2.0 * d * d);
    _sketch.yy = (north + south - 2.0 * _sketch.local) / (2.0 * d * d);
    _sketch.xy = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4.0 * d * d);
}

PlacedTile::Weights PlacedTile::weightsAt(double t)
{
    return {{0.5 * (t - 1.0) * (t - 2.0), t * (2.0 - t), 0.5 * t * (t - 1.0)}};
}

PlacedTile::Weights PlacedTile::slopesAt(double t)
{
    return {{t - 1.5, 2.0 - 2.0 * t, t - 0.5}};
}

PlacedTile::LatticePlace PlacedTile::latticePlace(double column, double row) const
{
    // Places beyond the tile, and those that are not a number, go to a cell at its edge.
    const int last = (_latticeSide - 1) / 2 - 1;
    const auto cell = [last](double nodes) {
        return !(nodes > 0.0) ? 0 : nodes < 2.0 * last ? static_cast<int>(0.5 * nodes) : last;
    };
    const double east = column / _latticeStep;
    const double north = row / _latticeStep;
    const int a = cell(east);
    const int b = cell(north);
    return {a, b, east - 2 * a, north - 2 * b};
}

PlacedTile::LatticeNode PlacedTile::blend(int macroColumn, int macroRow, const Weights& wx,
                                          const Weights& wy) const
{
    const LatticeNode* node =
        &_lattice[static_cast<std::size_t>(2 * macroRow) * _latticeSide + 2 * macroColumn];
    LatticeNode sum;
    for (int j = 0; j < 3; ++j, node += _latticeSide)
        for (int i = 0; i < 3; ++i)
        {
            const double w = wx.w[i] * wy.w[j];
            for (std::size_t k = 0; k < sum.values.size(); ++k)
                sum.values[k] += w * node[i].values[k];
        }
    return sum;
}

glm::dvec3 PlacedTile::curvedPosition(int column, int row, double heightM) const
{
    // The last sample belongs to the last macro cell, not to one that would begin there.
    const int last = (_latticeSide - 1) / 2 - 1;
    const int a = std::min(column >> _macroShift, last);
    const int b = std::min(row >> _macroShift, last);
    const auto weights = [this](int offset)
    {
        if ((offset & ((1 << _gridExponent) - 1)) == 0) [[likely]]
            return _weights[static_cast<std::size_t>(offset >> _gridExponent)];
        return weightsAt(static_cast<double>(offset) / _latticeStep);
    };
    const LatticeNode place =
        blend(a, b, weights(column - (a << _macroShift)), weights(row - (b << _macroShift)));
    return place.base() + heightM * place.up();
}

glm::dvec3 PlacedTile::positionAt(double column, double row, double heightM) const
{
    if (_placement == Placement::planar) return {column * _placeEastM, row * _placeNorthM, heightM};
    const LatticePlace place = latticePlace(column, row);
    const LatticeNode node =
        blend(place.macroColumn, place.macroRow, weightsAt(place.east), weightsAt(place.north));
    return node.base() + heightM * node.up();
}

/// One Newton step of positionAt(grid, h) = local in column, row and h; h is eliminated by looking along
/// `up`.
glm::dvec2 PlacedTile::newtonStep(const glm::dvec2& grid, const glm::dvec3& local) const
{
    const LatticePlace place = latticePlace(grid.x, grid.y);
    const Weights wx = weightsAt(place.east);
    const Weights wy = weightsAt(place.north);
    const LatticeNode here = blend(place.macroColumn, place.macroRow, wx, wy);
    const LatticeNode alongEast = blend(place.macroColumn, place.macroRow, slopesAt(place.east), wy);
    const LatticeNode alongNorth = blend(place.macroColumn, place.macroRow, wx, slopesAt(place.north));
    const double height = glm::dot(local - here.base(), here.up());
    const glm::dmat3 jacobian(alongEast.base() + height * alongEast.up(),
                              alongNorth.base() + height * alongNorth.up(), here.up());
    const glm::dvec3 residual = local - (here.base() + height * here.up());
    return glm::dvec2(glm::inverse(jacobian) * residual) * static_cast<double>(_latticeStep);
}

glm::dvec2 PlacedTile::gridAt(const glm::dvec3& local) const
{
    if (_placement == Placement::planar) return {local.x / _placeEastM, local.y / _placeNorthM};
    constexpr int kMaxSteps = 20;
    constexpr double kTinyStep = 1e-10; // of the tile: far below what a double resolves on the ground
    glm::dvec2 grid = gridNear(local);
    for (int i = 0; i < kMaxSteps; ++i)
    {
        const glm::dvec2 step = newtonStep(grid, local);
        grid += step;
        if (std::max(std::abs(step.x), std::abs(step.y)) < kTinyStep * _side) break;
    }
    return grid;
}

double PlacedTile::heightOf(const glm::dvec3& local) const
{
    const glm::dvec2 grid = gridAt(local);
    const glm::dvec3 base = positionAt(grid.x, grid.y, 0.0), up = positionAt(grid.x, grid.y, 1.0) - base;
    return glm::dot(local - base, up) / glm::dot(up, up);
}

glm::dvec2 PlacedTile::gridNear(const glm::dvec2& place) const
{
    if (_placement == Placement::planar) return {place.x / _placeEastM, place.y / _placeNorthM};
    const glm::dvec2 offset = place - _sketch.local;
    const glm::dvec2 d =
        _sketch.inverse * offset; // as if the Earth were flat, and that into the second order
    const glm::dvec2 bent = d.x * d.x * _sketch.xx + d.x * d.y * _sketch.xy + d.y * d.y * _sketch.yy;
    return _sketch.grid + _sketch.inverse * (offset - bent);
}

PlacedTile::GridMap PlacedTile::gridMap() const
{
    if (_placement == Placement::planar)
        return {glm::dmat2(1.0 / _placeEastM, 0.0, 0.0, 1.0 / _placeNorthM), {}};
    return {_sketch.inverse, _sketch.grid - _sketch.inverse * _sketch.local};
}

glm::dvec3 PlacedTile::localFromGeodetic(const Geodetic& geodetic) const
{
    assert(_placement == Placement::curved);
    glm::dvec3 local;
    frameAt(_origin).Forward(geodetic.latitudeDeg, geodetic.longitudeDeg, geodetic.heightM, local.x, local.y,
                             local.z);
    return local;
}

Geodetic PlacedTile::geodeticFromLocal(const glm::dvec3& local) const
{
    assert(_placement == Placement::curved);
    Geodetic geodetic;
    frameAt(_origin).Reverse(local.x, local.y, local.z, geodetic.latitudeDeg, geodetic.longitudeDeg,
                             geodetic.heightM);
    return geodetic;
}

} // namespace osgTerrainROAM::core
