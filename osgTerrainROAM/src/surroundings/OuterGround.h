// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Image>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "../material/TileableNoise.h"
#include "BorderLoop.h"
#include "OuterAxis.h"
#include "OuterRelief.h"

namespace osgTerrainROAM
{

/// The made-up ground beyond the data of a tile. At the border it has the heights and the slopes of the data;
/// farther out it tends to the mean of a stretch of border that grows with the distance, with hills like
/// those of the data, mirrored, and with broad noise. Where most of the stretch is water there is water of
/// its level: sea stays sea, and coasts wind.
/// Units: grid coordinates of the tile (TileGrid), metres. Threads: immutable.
/// Cost: about 0.3 µs a call.
class OuterGround
{
public:
    /// `land`: landMap() of the tile. `reachM`: how far the ground goes beyond the data.
    OuterGround(const core::PlacedTile& tile, const osg::Image& land, double reachM);

    struct Site
    {
        double heightM;
        double water; ///< share, 0…1; from ½ on it is water
    };
    /// The ground at a grid position; within the data it is that of the nearest sample.
    Site at(const glm::dvec2& grid) const;

    /// The position in the tile's frame: beyond the data it continues the grid linearly and falls with the
    /// Earth's curvature.
    glm::dvec3 position(const glm::dvec2& grid, double heightM) const;

    /// The gradient of a height in the tile's frame, from that along the grid's axes (metres per grid unit).
    glm::dvec2 localGradient(const glm::dvec2& perGrid) const
    {
        return glm::transpose(_gridFromLocal) * perGrid;
    }

    const core::PlacedTile& tile() const { return _tile; }
    const BorderLoop& border() const { return _border; }
    /// The axes of the maps and the mesh. Hills finer than their texels are left out.
    const OuterAxis& columns() const { return _columns; }
    const OuterAxis& rows() const { return _rows; }
    glm::dvec2 last() const { return _last; }     ///< grid position of the last sample
    double spacingM() const { return _spacingM; } ///< of the raster's samples

private:
    void makeRelief();
    double reliefAt(const glm::dvec2& grid, double texelM) const;
    double hillsM(const glm::dvec2& grid, double distanceM) const;
    double coastNoiseM(const glm::dvec2& place, double distanceM, double shift) const;
    BorderLoop::Means borderBeside(const glm::dvec2& grid, const glm::dvec2& border, double samples) const;
    double heightNear(const glm::dvec2& grid) const;

    const core::PlacedTile& _tile;
    const osg::Image& _land;
    MapGrid _map;
    BorderLoop _border;
    glm::dvec2 _last;
    glm::dmat2 _gridFromLocal, _localFromGrid;
    double _spacingM, _sideM;
    TileableNoise _noise;

    OuterAxis _columns, _rows;
    OuterRelief _relief; ///< a coarse grid over the data
    double _reliefCellM = 1.0;
    double _lowestM = 0.0;
};

} // namespace osgTerrainROAM
