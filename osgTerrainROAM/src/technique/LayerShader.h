// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <mutex>
#include <string>

#include <osg/Program>

#include "ColourLayers.h"

namespace osgTerrainROAM
{

/// Programs that draw tiles as the fixed functions would: lights, material and fog of the scene, textures modulated in
/// the order of their units; but with normals per pixel. One for each combination of layers, made when first asked for.
/// Threads: any.
class LayerPrograms
{
public:
    osg::ref_ptr<osg::Program> program(const std::vector<ColourLayer>& layers, bool hasHoles);

private:
    std::mutex _mutex;
    std::map<std::string, osg::ref_ptr<osg::Program>> _programs; ///< by what is drawn
};

} // namespace osgTerrainROAM
