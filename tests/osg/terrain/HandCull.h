// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osg/Camera>
#include <osg/Drawable>
#include <osg/FrameStamp>
#include <osg/Node>

namespace handcull
{

/// A camera in perspective, 60° wide, 800×600 pixels, near 1 m.
osg::ref_ptr<osg::Camera> cameraAt(const osg::Vec3d& eye, const osg::Vec3d& target);

/// What a cull traversal, run by hand without a graphics context, put into the render graph.
struct Culled
{
    std::vector<osg::ref_ptr<osg::Drawable>> drawables;
    osg::Matrixd projection; ///< after OSG's clamping to near and far, where it computes them

    std::uint64_t triangles() const; ///< through osg::TriangleFunctor
};

/// Culls `scene` for one camera in one frame. `computeNearFar`: as osgViewer does by default.
Culled cull(osg::Node& scene, osg::Camera& camera, unsigned int frame, bool computeNearFar = false,
            double simulationTimeS = 0.0);

} // namespace handcull
