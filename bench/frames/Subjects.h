// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <osgTerrainROAM/RoamDrawable>

#include "FrameCosts.h"
#include "Look.h"
#include "Request.h"

namespace framebench
{

/// One way to draw the terrain, and the times of its frames.
struct Subject
{
    std::string name, draws;
    osg::ref_ptr<osg::Node> node;
    osg::ref_ptr<osgTerrainROAM::RoamDrawable> roam; ///< null: its triangles are counted in the draws
    FrameCosts costs;
};

/// Makes all ways: ours at each tolerance without and with morphing, the full grid, the GeometryTechnique of
/// osgTerrain. The others are compared with the first.
std::vector<Subject> subjectsOf(const Request& request, Look look);

} // namespace framebench
