// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <glm/gtc/type_ptr.hpp>

#include <osgTraversal/CullFacts>

namespace osgTraversal
{

const osg::Camera* mainCameraOf(osgUtil::CullVisitor& visitor)
{
    const osg::Camera* current = visitor.getCurrentCamera();
    const osg::Camera* root = visitor.getRenderStage()->getCamera();
    const bool depends =
        current && root && current != root && current->getReferenceFrame() != osg::Transform::ABSOLUTE_RF;
    return depends ? root : nullptr;
}

unsigned int frameOf(const osgUtil::CullVisitor& visitor)
{
    return visitor.getFrameStamp() ? visitor.getFrameStamp()->getFrameNumber() : 0;
}

std::optional<unsigned int> contextIdOf(osgUtil::CullVisitor& visitor)
{
    if (!visitor.getState()) return std::nullopt;
    return visitor.getState()->getContextID();
}

double lodScaleOf(const osgUtil::CullVisitor& visitor)
{
    return std::max(static_cast<double>(visitor.getLODScale()), 1e-6);
}

bool seeksNearFar(const osgUtil::CullVisitor& visitor)
{
    return visitor.getComputeNearFarMode() != osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR;
}

glm::dmat4 toGlm(const osg::Matrixd& matrix)
{
    return glm::make_mat4(matrix.ptr());
}

double eyePerLocal(const osg::Matrixd& eyeFromLocal)
{
    const osg::Vec3d scale = eyeFromLocal.getScale();
    const double mean = std::cbrt(scale.x() * scale.y() * scale.z());
    // The rounding of a rotation must not change distances when the camera turns.
    return std::abs(mean - 1.0) < 1e-9 || !(mean > 0.0) ? 1.0 : mean;
}

viewlod::ViewState viewStateOf(osgUtil::CullVisitor& visitor, const osg::Matrixd& eyeFromLocal,
                               const glm::dmat4& projection)
{
    const osg::Viewport* viewport = visitor.getViewport();
    const int width = viewport ? static_cast<int>(viewport->width()) : 1;
    const int height = viewport ? static_cast<int>(viewport->height()) : 1;
    return viewlod::ViewState::fromMatrices(toGlm(eyeFromLocal), projection, width, height);
}

viewlod::ViewState detailViewOf(osgUtil::CullVisitor& visitor)
{
    const glm::dmat4 projection = toGlm(*visitor.getProjectionMatrix());
    viewlod::ViewState view = viewStateOf(visitor, *visitor.getModelViewMatrix(), projection);
    const osg::Camera* const main = mainCameraOf(visitor);
    if (!main || !main->getViewport() || !isParallel(projection)) return view;
    const viewlod::ViewState seen = viewlod::ViewState::fromMatrices(
        toGlm(*visitor.getModelViewMatrix()), toGlm(main->getProjectionMatrix()),
        static_cast<int>(main->getViewport()->width()), static_cast<int>(main->getViewport()->height()));
    view.pixelsPerTangent = seen.pixelsPerTangent;
    view.cornerStretch = seen.cornerStretch;
    view.nearM = seen.nearM;
    return view;
}

} // namespace osgTraversal
