// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/MirrorCamera.h"

#include <algorithm>

#include <glm/gtc/matrix_transform.hpp>

namespace scenery
{

MirrorView mirrorView(const models::InteriorMirror& mirror, const Pose& vehicle, const glm::dvec3& eyeWorld,
                      double farM)
{
    constexpr double kLeastNearM = 1.0; // the vehicle itself is not drawn
    const glm::dvec3 low = vehicle.worldFromBodyPoint(mirror.lowLeft);
    const glm::dvec3 across = vehicle.worldFromBodyPoint(mirror.lowRight) - low,
                     high = vehicle.worldFromBodyPoint(mirror.topLeft) - low;
    const glm::dvec3 right = glm::normalize(across), up = glm::normalize(high), out = glm::cross(right, up);
    const double beforeM = glm::dot(eyeWorld - low, out);
    MirrorView made;
    made.isSeen = beforeM > 0.01;
    if (!made.isSeen) return made;
    const glm::dvec3 image = eyeWorld - 2.0 * beforeM * out;
    made.view = viewFromWorld({image, glm::dmat3(out, right, up)});
    const glm::dvec3 corner = low - image;
    const double nearM = std::max(beforeM, kLeastNearM), scale = nearM / beforeM;
    const double left = -glm::dot(corner + across, right) * scale, rightM = -glm::dot(corner, right) * scale;
    const double bottom = glm::dot(corner, up) * scale, top = glm::dot(corner + high, up) * scale;
    made.projection = glm::frustum(left, rightM, bottom, top, nearM, farM);
    return made;
}

bool isInPicture(const models::InteriorMirror& mirror, const Pose& vehicle, const glm::dmat4& clipFromWorld)
{
    const glm::dvec3 topRight = mirror.lowRight + mirror.topLeft - mirror.lowLeft;
    int left = 0, right = 0, below = 0, above = 0, behind = 0;
    for (const glm::dvec3& corner : {mirror.lowLeft, mirror.lowRight, mirror.topLeft, topRight})
    {
        const glm::dvec4 clip = clipFromWorld * glm::dvec4(vehicle.worldFromBodyPoint(corner), 1.0);
        left += clip.x < -clip.w;
        right += clip.x > clip.w;
        below += clip.y < -clip.w;
        above += clip.y > clip.w;
        behind += clip.w <= 0.0;
    }
    return std::max({left, right, below, above, behind}) < 4;
}

osg::ref_ptr<osg::Camera> makeMirrorCamera(osg::Texture2D& picture)
{
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setRenderOrder(osg::Camera::PRE_RENDER);
    camera->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera->attach(osg::Camera::COLOR_BUFFER, &picture);
    camera->attach(osg::Camera::DEPTH_BUFFER, GL_DEPTH_COMPONENT24);
    camera->setViewport(0, 0, picture.getTextureWidth(), picture.getTextureHeight());
    camera->setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
    camera->setProjectionResizePolicy(osg::Camera::FIXED);
    camera->setAllowEventFocus(false);
    rest(*camera);
    return camera;
}

void setMirrorView(osg::Camera& camera, const MirrorView& view)
{
    if (!view.isSeen) return rest(camera);
    camera.setViewMatrix(osg::Matrixd(&view.view[0][0]));
    camera.setProjectionMatrix(osg::Matrixd(&view.projection[0][0]));
    camera.setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    camera.setCullMask(~0U);
}

void rest(osg::Camera& camera)
{
    camera.setClearMask(0);
    camera.setCullMask(0);
}

} // namespace scenery
