// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include <osg/Matrixd>
#include <osgTerrain/TerrainTile>

#include <osgTerrainROAM/core/roam/RoamTile.h>

#include "ElevationSamples.h"

namespace osgTerrainROAM
{

/// The ground of an osgTerrain tile in the form that refinement needs.
/// Frames: "model" is the frame of the tile's locator; "local" the RoamTile's, metres or the model's unit
/// times a power of two.
struct TileGround
{
    std::shared_ptr<const core::RoamTile> tile;
    std::shared_ptr<const ElevationSamples> samples;
    osg::ref_ptr<const osgTerrain::Locator> locator;
    osg::Matrixd modelFromLocal;
    double heightScale = 1.0; ///< local height of a layer height of 1
    double skirtM = 0.0;      ///< local; a skirt is never less deep
};

/// The locator that places a tile: its elevation layer's, else the first colour layer's, else the tile's own.
const osgTerrain::Locator* masterLocator(const osgTerrain::TerrainTile& tile);

/// GEOCENTRIC: on the ellipsoid, in the east-north-up frame of the tile's middle. Other types: the plane that
/// the locator's transformation makes of the unit square. Cost: about 1 µs a sample. Empty: no locator, no
/// heights.
std::optional<TileGround> tileGround(const osgTerrain::TerrainTile& tile);

} // namespace osgTerrainROAM
