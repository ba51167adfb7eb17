// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <mutex>
#include <string>

#include <osg/Program>

#include "ColourLayers.h"

namespace osgTerrainROAM
{

/// The programs that draw tiles as the fixed functions would, but with normals per pixel: lights, material
/// and fog of the scene, textures modulated in the order of their units. There is one for each combination of
/// layers, made on first use.
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
