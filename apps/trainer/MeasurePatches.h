// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <osg/GraphicsContext>
#include <osgViewer/Viewer>

#include <osgTerrainROAM/RoamTerrain>

namespace trainer
{

/// Chooses the terrain's patch exponent: draws frames with some of them, each to its last pixel, and keeps what was
/// fastest. `moveEye` is called before each frame. Returns what it found, in a line of text.
/// The choice depends on the machine and on what else it does: not for pictures that shall be the same everywhere.
/// Precondition: nothing captures the contexts yet.
std::string measurePatches(osgTerrainROAM::RoamTerrain& terrain, osgViewer::Viewer& viewer,
                           const std::vector<osg::ref_ptr<osg::GraphicsContext>>& contexts,
                           const std::function<void()>& moveEye);

} // namespace trainer
