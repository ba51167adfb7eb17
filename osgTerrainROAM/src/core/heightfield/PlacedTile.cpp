// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <utility>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

namespace
{

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

TileFrame frameOf(const TileGrid& grid, const HeightField& field, const TileSamples& samples,
                  const PlacedTileOptions& options)
{
    if (options.placement == Placement::planar || !field.net)
        return {grid, field.spacingEastM, field.spacingNorthM};
    const int middle = grid.side() / 2;
    return {grid, GeodeticLattice(grid, *field.net, options.origin), samples.heightM(middle, middle)};
}

double diagonalM(const TileGrid& grid, const TileFrame& frame)
{
    const double last = grid.side() - 1;
    return std::max(glm::distance(frame.positionAt(0, 0, 0.0), frame.positionAt(last, last, 0.0)),
                    glm::distance(frame.positionAt(last, 0, 0.0), frame.positionAt(0, last, 0.0)));
}

} // namespace

PlacedTile::PlacedTile(HeightField field, const PlacedTileOptions& options)
    : _field(complete(std::move(field))),
      _grid(_field, gridExponentOf(_field, options.gridExponent)),
      _samples(_grid, _field, options.storage),
      _frame(frameOf(_grid, _field, _samples, options))
{
    _samples.setRadiusRange(diagonalM(_grid, _frame));
}

} // namespace osgTerrainROAM::core
