// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <osgTerrain/Layer>
#include <osgTerrain/Terrain>
#include <osgTerrain/TerrainTile>

namespace techniquescene
{

/// A hilly height, in metres, that neighbours agree about: a function of the place. `x`, `y`: metres.
double hillAt(double x, double y);

/// One tile of a made database. Its ground is hillAt() over x0…x0 + sizeM, y0…y0 + sizeM.
struct TileSpec
{
    int columns = 65, rows = 65;
    double x0 = 0.0, y0 = 0.0, sizeM = 1920.0;
    osgTerrain::Locator::CoordinateSystemType type = osgTerrain::Locator::PROJECTED;
    bool coloured = true; ///< with an image that tells where it is: red eastwards, green northwards
    double alpha = 1.0;
};

/// GEOCENTRIC: the metres become seconds of arc about 46° north, 8° east, 30 m each.
osg::ref_ptr<osgTerrain::Locator> locatorOf(const TileSpec& spec);
osg::ref_ptr<osgTerrain::HeightFieldLayer> elevationOf(const TileSpec& spec);
osg::ref_ptr<osg::Image> imageOf(const TileSpec& spec);
osg::ref_ptr<osgTerrain::TerrainTile> tileOf(const TileSpec& spec);

/// A terrain of `side`² tiles side by side, each as `spec` but for its place.
osg::ref_ptr<osgTerrain::Terrain> terrainOf(int side, const TileSpec& spec);

/// A database of two levels in the folder: DATABASE.osgb, a Terrain over one PagedLOD with a tile of 65²
/// samples, whose four children with as many each are read when the eye is nearer than `rangeM`. Returns the
/// file.
std::filesystem::path writePagedDatabase(const std::filesystem::path& folder, double rangeM,
                                         const std::string& extension = "osgb");

} // namespace techniquescene
