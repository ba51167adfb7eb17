// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <osg/Texture2D>

namespace osgRoads
{

using FloatRow = std::array<float, 16>;

/// Puts rows of 16 numbers into a texture of floats: four texels a row, 256 rows in a line of the texture.
/// Rows beyond what a texture holds (4 million) are left out.
osg::ref_ptr<osg::Texture2D> makeRowTexture(const std::vector<FloatRow>& rows);

} // namespace osgRoads
