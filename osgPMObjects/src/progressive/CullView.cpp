// SPDX-License-Identifier: Apache-2.0
#include "CullView.h"

#include <osgTraversal/CullFacts>

namespace osgPMObjects
{

CullView cullViewOf(osgUtil::CullVisitor& visitor)
{
    CullView cull;
    cull.camera = visitor.getCurrentCamera();
    cull.mainCamera = osgTraversal::mainCameraOf(visitor);
    cull.frame = osgTraversal::frameOf(visitor);
    if (const osg::FrameStamp* const stamp = visitor.getFrameStamp()) cull.timeS = stamp->getSimulationTime();
    cull.contextId = osgTraversal::contextIdOf(visitor);
    cull.lodScale = osgTraversal::lodScaleOf(visitor);
    const osg::Matrixd& eyeFromLocal = *visitor.getModelViewMatrix();
    cull.metresPerUnit = osgTraversal::eyePerLocal(eyeFromLocal);
    const double unitsPerMetre = 1.0 / cull.metresPerUnit;
    const osg::Matrixd eyeFromMetres =
        osg::Matrixd::scale(unitsPerMetre, unitsPerMetre, unitsPerMetre) * eyeFromLocal;
    const glm::dmat4 projection = osgTraversal::toGlm(*visitor.getProjectionMatrix());
    cull.isParallel = osgTraversal::isParallel(projection);
    cull.view = osgTraversal::viewStateOf(visitor, eyeFromMetres, projection);
    if (osgTraversal::seeksNearFar(visitor)) cull.view.nearM = 0.0;
    return cull;
}

} // namespace osgPMObjects
