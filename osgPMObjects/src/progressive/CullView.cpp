// SPDX-License-Identifier: Apache-2.0
#include "CullView.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/type_ptr.hpp>

namespace osgPMObjects
{

namespace
{

/// OSG multiplies row vectors and stores rows, GLM columns: the same sixteen numbers.
glm::dmat4 toGlm(const osg::Matrixd& matrix)
{
    return glm::make_mat4(matrix.ptr());
}

/// Eye-space length of a unit of the local frame.
double eyePerLocal(const osg::Matrixd& eyeFromLocal)
{
    const osg::Vec3d scale = eyeFromLocal.getScale();
    const double mean = std::cbrt(scale.x() * scale.y() * scale.z());
    // A rotation's rounding must not look like another distance each time the head turns.
    return std::abs(mean - 1.0) < 1e-9 || !(mean > 0.0) ? 1.0 : mean;
}

/// Shadow and reflection passes hang below their main view, relative to it or with its viewpoint. A nested camera with a
/// frame of its own looks for itself.
const osg::Camera* mainCameraOf(osgUtil::CullVisitor& visitor)
{
    const osg::Camera* current = visitor.getCurrentCamera();
    const osg::Camera* root = visitor.getRenderStage()->getCamera();
    const bool depends =
        current && root && current != root && current->getReferenceFrame() != osg::Transform::ABSOLUTE_RF;
    return depends ? root : nullptr;
}

} // namespace

CullView cullViewOf(osgUtil::CullVisitor& visitor)
{
    CullView cull;
    cull.camera = visitor.getCurrentCamera();
    cull.mainCamera = mainCameraOf(visitor);
    if (const osg::FrameStamp* const stamp = visitor.getFrameStamp())
    {
        cull.frame = stamp->getFrameNumber();
        cull.timeS = stamp->getSimulationTime();
    }
    if (visitor.getState()) cull.contextId = visitor.getState()->getContextID();
    cull.lodScale = std::max(static_cast<double>(visitor.getLODScale()), 1e-6);
    const osg::Matrixd& eyeFromLocal = *visitor.getModelViewMatrix();
    cull.metresPerUnit = eyePerLocal(eyeFromLocal);
    const double unitsPerMetre = 1.0 / cull.metresPerUnit;
    const glm::dmat4 eyeFromMetres =
        toGlm(osg::Matrixd::scale(unitsPerMetre, unitsPerMetre, unitsPerMetre) * eyeFromLocal);
    const glm::dmat4 projection = toGlm(*visitor.getProjectionMatrix());
    const osg::Viewport* viewport = visitor.getViewport();
    const int width = viewport ? static_cast<int>(viewport->width()) : 1;
    const int height = viewport ? static_cast<int>(viewport->height()) : 1;
    cull.view = viewlod::ViewState::fromMatrices(eyeFromMetres, projection, width, height);
    if (projection[2][3] == 0.0) cull.metresPerPixel = cull.lodScale / cull.view.pixelsPerTangent;
    // While OSG is still looking for near and far planes, what stands in the matrix means nothing.
    if (visitor.getComputeNearFarMode() != osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR) cull.view.nearM = 0.0;
    return cull;
}

} // namespace osgPMObjects
