// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include <osg/BoundingBox>
#include <osgUtil/CullVisitor>

namespace osgTerrainROAM
{

/// Tells OSG, where it computes the near and far planes, how near and how far a surface reaches in eye space, and allows so
/// near a plane. `box`: around the surface, in the frame of the model-view matrix. `cornerStretch`: viewlod::ViewState.
inline void tellNearFar(osgUtil::CullVisitor& visitor, const osg::BoundingBox& box, double cornerStretch,
                        double nearestM)
{
    const osg::Matrixd& eyeFromLocal = *visitor.getModelViewMatrix();
    double farM = 0.0;
    for (unsigned int i = 0; i < 8; ++i)
        farM = std::max(farM, -(osg::Vec3d(box.corner(i)) * eyeFromLocal).z());
    if (farM <= 0.0) return;
    // A point at the corner of the frame is farther away than it is deep.
    const double nearM = std::max(0.95 * nearestM / std::sqrt(cornerStretch), farM * 1e-6);
    if (nearM < visitor.getCalculatedNearPlane()) visitor.setCalculatedNearPlane(nearM);
    if (farM > visitor.getCalculatedFarPlane()) visitor.setCalculatedFarPlane(farM);
    const double ratio = 0.95 * visitor.getCalculatedNearPlane() / visitor.getCalculatedFarPlane();
    if (ratio < visitor.getNearFarRatio()) visitor.setNearFarRatio(ratio);
}

} // namespace osgTerrainROAM
