// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <osg/ref_ptr>

namespace osg
{
class GraphicsContext;
}
namespace osgViewer
{
class Viewer;
}
namespace osgTerrainROAM
{
class RoamTerrain;
}

namespace trainer
{

/// Chooses the patch exponent of the terrain: measures complete frames with some exponents and keeps the
/// fastest. `moveEye` is called before each frame. Returns the result as one line of text.
/// The choice depends on the machine and its load: do not use it for frames that must be the same everywhere.
/// Precondition: nothing captures the contexts yet.
std::string measurePatches(osgTerrainROAM::RoamTerrain& terrain, osgViewer::Viewer& viewer,
                           const std::vector<osg::ref_ptr<osg::GraphicsContext>>& contexts,
                           const std::function<void()>& moveEye);

} // namespace trainer
