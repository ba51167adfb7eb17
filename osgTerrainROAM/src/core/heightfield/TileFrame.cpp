// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <osgTerrainROAM/core/heightfield/TileFrame.h>

#include "LocalFrame.h"

namespace osgTerrainROAM::core
{

TileFrame::TileFrame(const TileGrid& grid, double spacingEastM, double spacingNorthM)
    : _side(grid.side()),
      _pointEastM(std::ldexp(spacingEastM, -grid.exponent())),
      _pointNorthM(std::ldexp(spacingNorthM, -grid.exponent())),
      _vertexStepM(fittingStepM())
{
}

TileFrame::TileFrame(const TileGrid& grid, GeodeticLattice lattice, double middleHeightM)
    : _side(grid.side()),
      _lattice(std::move(lattice)),
      _plan(_side,
            [&](double column, double row) { return glm::dvec2(positionAt(column, row, middleHeightM)); }),
      _vertexStepM(fittingStepM())
{
}

double TileFrame::fittingStepM() const
{
    constexpr double kBeyondM = 20000.0; // higher than any land, or displaced by morphing
    const double last = _side - 1;
    double farthestM = 0.0;
    for (const double column : {0.0, 0.5 * last, last})
        for (const double row : {0.0, 0.5 * last, last})
            for (int axis = 0; axis < 3; ++axis)
                farthestM = std::max(farthestM, std::abs(positionAt(column, row, 0.0)[axis]));
    return std::exp2(std::ceil(std::log2(1.1 * farthestM + kBeyondM)) - 30.0);
}

glm::dvec2 TileFrame::gridAt(const glm::dvec3& local) const
{
    glm::dvec2 grid = gridNear(local);
    if (!_lattice) return grid;
    constexpr int kMaxSteps = 20;
    constexpr double kTinyStep = 1e-10; // of the tile: far below what a double resolves on the ground
    for (int i = 0; i < kMaxSteps; ++i)
    {
        const glm::dvec2 step = _lattice->newtonStep(grid, local);
        grid += step;
        if (std::max(std::abs(step.x), std::abs(step.y)) < kTinyStep * _side) break;
    }
    return grid;
}

double TileFrame::heightOf(const glm::dvec3& local) const
{
    const glm::dvec2 grid = gridAt(local);
    const glm::dvec3 base = positionAt(grid.x, grid.y, 0.0), up = positionAt(grid.x, grid.y, 1.0) - base;
    return glm::dot(local - base, up) / glm::dot(up, up);
}

TileFrame::GridMap TileFrame::gridMap() const
{
    if (_lattice) return {_plan.linear(), _plan.offset()};
    return {glm::dmat2(1.0 / _pointEastM, 0.0, 0.0, 1.0 / _pointNorthM), {}};
}

glm::dvec3 TileFrame::localFromGeodetic(const Geodetic& geodetic) const
{
    assert(_lattice);
    glm::dvec3 local;
    localFrameAt(origin()).Forward(geodetic.latitudeDeg, geodetic.longitudeDeg, geodetic.heightM, local.x,
                                   local.y, local.z);
    return local;
}

Geodetic TileFrame::geodeticFromLocal(const glm::dvec3& local) const
{
    assert(_lattice);
    Geodetic geodetic;
    localFrameAt(origin()).Reverse(local.x, local.y, local.z, geodetic.latitudeDeg, geodetic.longitudeDeg,
                                   geodetic.heightM);
    return geodetic;
}

} // namespace osgTerrainROAM::core
