// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

#include "measurement/flights/BenchmarkFlight.h"

namespace measurement
{

/// A camera on a random walk of at most half a cell a frame in each axis. Every hundredth frame it jumps to a
/// random position 300 m above the ground. The same on every machine.
class RandomWalk
{
public:
    static constexpr int kFrames = 10000, kFramesBetweenLeaps = 100;

    explicit RandomWalk(const osgTerrainROAM::core::PlacedTile& tile)
        : _tile(tile), _view(BenchmarkFlight{}.view(tile, 0))
    {
    }

    const viewlod::ViewState& next()
    {
        if (_frame++ % kFramesBetweenLeaps == 0)
        {
            const double last = _tile.grid().dataColumns() - 1, column = unit() * last, row = unit() * last;
            const double groundM = _tile.samples().heightM(static_cast<int>(column), static_cast<int>(row));
            _view.eyeWorld = _tile.frame().positionAt(column, row, groundM + 300.0);
        }
        const double east = unit(), north = unit(), up = unit();
        _view.eyeWorld += (glm::dvec3(east, north, up) - 0.5) * _tile.field().spacingEastM;
        return _view;
    }

private:
    double unit() { return _random() / 4294967296.0; }

    const osgTerrainROAM::core::PlacedTile& _tile;
    viewlod::ViewState _view;
    std::mt19937 _random{3};
    int _frame = 0;
};

} // namespace measurement
