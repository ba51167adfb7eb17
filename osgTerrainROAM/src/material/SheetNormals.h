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

/// Normal maps of the sheets of a tile, with one texel a sample; of the finest kMostMaps sheets only.
/// Threads: the update phase. Memory: 4 B a sample, here and on the graphics card, and a third more there.
class SheetNormals
{
public:
    static constexpr std::size_t kMostMaps = 4;

    /// Uses one texture unit for each map, from `firstUnit` on.
    SheetNormals(const core::PlacedTile& tile, osg::StateSet& stateSet, unsigned firstUnit);

    int maps() const { return static_cast<int>(_maps.size()); }

    /// Computes the texels again whose samples or neighbours have moved.
    void follow(const core::PlacedTile& tile, std::span<const core::GridRect> moved);

private:
    struct Map
    {
        MapGrid grid;
        osg::ref_ptr<osg::Image> image;
    };
    std::vector<Map> _maps; ///< coarse before fine
};

/// The weight of each layer of the grain's bumps over data with this spacing: bumps that the data can show
/// themselves have weight 0.
osg::Vec4f bumpinessOver(double spacingM);

} // namespace osgTerrainROAM
