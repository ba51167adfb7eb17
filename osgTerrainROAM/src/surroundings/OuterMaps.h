// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Image>

#include <osgTerrainROAM/Climate>

#include "OuterAxis.h"
#include "OuterGround.h"

namespace osgTerrainROAM
{

/// The surface maps of the surroundings, as NormalMap.h and LandMap.h make them of the data. Texel (x, y) is
/// the ground at the grid position of texel x of the one axis and y of the other.
struct OuterMaps
{
    osg::ref_ptr<osg::Image> normals, land;
};

/// Cost: about 0.2 s of one core.
OuterMaps outerMaps(const OuterGround& ground, const OuterAxis& columns, const OuterAxis& rows,
                    const Climate& climate);

} // namespace osgTerrainROAM
