// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osg/Geometry>

#include <osgPMObjects/core/field/LevelLadder.h>

#include <osgPMObjects/ProgressiveShape>

namespace osgPMObjects
{

/// The finest level of a shape by material, as plain geometry that intersections look into and nobody draws.
/// Shares the shape's arrays and states, so that hits find texture coordinates and materials. Where osgDB's
/// registry asks for KdTrees, it has them.
/// Frame: about the shape's origin. Memory: 12 B a face, and its KdTree. Threads: bounds are there already,
/// so any may read it.
std::vector<osg::ref_ptr<osg::Geometry>> finestFaces(const ProgressiveShape& shape,
                                                     const core::LevelLadder& ladder);

} // namespace osgPMObjects
