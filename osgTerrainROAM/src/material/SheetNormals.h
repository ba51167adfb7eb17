// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include <osg/Image>
#include <osg/StateSet>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "MapGrid.h"

namespace osgTerrainROAM
{

/// Normal maps of the sheets of a tile, each with one texel a sample, over the raster's; the finest kMostMaps of them.
/// Threads: the update phase. Memory: 4 B a sample, here and on the graphics card, and a third more there.
class SheetNormals
{
public:
    static constexpr std::size_t kMostMaps = 4;

    /// Takes a texture unit for each, from `firstUnit` on.
    SheetNormals(const core::PlacedTile& tile, osg::StateSet& stateSet, unsigned firstUnit);

    int maps() const { return static_cast<int>(_maps.size()); }

    /// Draws texels again whose samples or neighbours have moved.
    void follow(const core::PlacedTile& tile, std::span<const core::GridRect> moved);

private:
    struct Map
    {
        MapGrid grid;
        osg::ref_ptr<osg::Image> image;
    };
    std::vector<Map> _maps; ///< coarse before fine
};

/// How much of each layer of invented bumps counts over data of a spacing: those that the data themselves show are not invented a
/// second time.
osg::Vec4f bumpinessOver(double spacingM);

} // namespace osgTerrainROAM
