// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <osgOffscreen/OffscreenViewer>
#include <osgTerrainROAM/RoamTerrain>

namespace syntheticscene
{

/// A place to look from and what is seen there.
struct Viewpoint
{
    std::string name;
    osg::Vec3d eye, target;
};

/// A driver's eye 1.5 m above the beach, a pilot's at 300 m, the whole island from 3000 m.
std::vector<Viewpoint> viewpoints(const osgTerrainROAM::core::PlacedTile& tile);

/// An island of 200×180 samples, 25 m apart, in the sea, with hills, a peak and a lake; no library function
/// decides a height's last bit. Planar, in the midst of a 257² tile, so that its edges are clipped.
osgTerrainROAM::core::HeightField islandField();
std::shared_ptr<const osgTerrainROAM::core::RoamTile> islandTile();

/// With a material and the light of an afternoon.
osg::ref_ptr<osgTerrainROAM::RoamTerrain> islandTerrain(double tolerancePx = 1.0);

/// The same, to be edited on a grid of 0.78 m.
osg::ref_ptr<osgTerrainROAM::RoamTerrain> editableIsland();

/// A tile with a material and the light of an afternoon.
osg::ref_ptr<osgTerrainROAM::RoamTerrain> dressed(const std::shared_ptr<osgTerrainROAM::core::RoamTile>& tile,
                                                  double tolerancePx);

/// A viewer of 320×180 pixels on a node.
std::unique_ptr<osgOffscreen::OffscreenViewer> viewerOn(osg::Node* node, osgOffscreen::Backend backend);

void look(osgOffscreen::OffscreenViewer& viewer, const Viewpoint& from);

} // namespace syntheticscene
