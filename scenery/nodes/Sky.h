// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Node>
#include <osgSky/Atmosphere>

namespace scenery
{

/// Makes the sky: one rectangle over the whole image, drawn behind everything else, coloured by direction
/// with the function of the atmosphere. Distant terrain fades to the same function, so the horizon has no
/// seam. Stars and moon are another node's (NightSky).
/// Needs the uniforms of an Atmosphere above it in the graph. It follows every camera, off-axis ones too,
/// does not affect near and far planes, and is never culled.
osg::ref_ptr<osg::Node> makeSky();

} // namespace scenery
