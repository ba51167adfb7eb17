// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osg/Texture2D>

#include <osgRoads/core/surface/RoadMesh.h>

namespace osgRoads
{

/// Puts mark rows into a texture of floats: four texels a row (two of each line: offset, width, dash, period; phase and
/// colour), 256 rows in a line of the texture. Rows beyond what a texture holds (4 million) are not painted.
osg::ref_ptr<osg::Texture2D> makeMarkTexture(const std::vector<core::MarkRow>& rows);

} // namespace osgRoads
