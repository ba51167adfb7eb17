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

/// One way to draw the terrain, and what its frames took.
struct Subject
{
    std::string name, draws;
    osg::ref_ptr<osg::Node> node;
    osg::ref_ptr<osgTerrainROAM::RoamDrawable> roam; ///< null: its triangles are counted in the draws
    FrameCosts costs;
};

/// Ours at each tolerance without and with morphing, the full grid, osgTerrain's GeometryTechnique; the first is the one
/// that the others are compared with.
std::vector<Subject> subjectsOf(const Request& request, Look look);

} // namespace framebench
