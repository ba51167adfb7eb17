// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Node>

#include <osgTerrainROAM/Atmosphere>

namespace scenery
{

/// The sky: one rectangle over the whole picture, drawn behind everything else, coloured by direction with the
/// atmosphere's own function. Distant terrain fades to the same function, so the horizon has no seam. Stars come out
/// as the sun goes down; they keep their size on the screen and do not twinkle.
/// Needs the uniforms of `atmosphere` above it in the graph. It follows every camera, off-axis ones too, takes no
/// part in near and far planes, and is never culled.
osg::ref_ptr<osg::Node> makeSky();

} // namespace scenery
