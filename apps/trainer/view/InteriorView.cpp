// SPDX-License-Identifier: Apache-2.0
#include "view/InteriorView.h"

#include "scenery/nodes/EntityLook.h"
#include "scenery/nodes/MirrorCamera.h"

namespace trainer
{

namespace
{

constexpr double kNearM = 0.05, kFarM = 60.0; ///< to the tip of a wing
constexpr double kMirrorFarM = 20'000.0;
constexpr int kAfterPicture = 5; ///< before what is drawn over it (hud)

osg::Matrixd matrixOf(const glm::dmat4& matrix)
{
    return osg::Matrixd(&matrix[0][0]); // GLM's columns are OSG's rows
}

} // namespace

std::unique_ptr<InteriorView> InteriorView::create(const simulation::ScenarioObject& vehicle,
                                                   const glm::dvec3& eyeInBody)
{
    auto model = scenery::models::makeInterior(scenery::entityLook(vehicle).shape, eyeInBody);
    return model ? std::unique_ptr<InteriorView>(new InteriorView(std::move(*model))) : nullptr;
}

InteriorView::InteriorView(scenery::models::InteriorModel model)
    : _interior(std::move(model)), _camera(new osg::Camera)
{
    _camera->setName("interior");
    _camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    _camera->setRenderOrder(osg::Camera::POST_RENDER, kAfterPicture);
    _camera->setClearMask(GL_DEPTH_BUFFER_BIT);
    _camera->setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
    _camera->setProjectionResizePolicy(osg::Camera::FIXED);
    _camera->setAllowEventFocus(false);
}

void InteriorView::addTo(osgViewer::View& view, osg::Camera& picture, osg::StateSet& air, osg::Node& scene)
{
    _camera->setGraphicsContext(picture.getGraphicsContext());
    // Not the camera's own: a camera keeps its viewport in its state.
    const osg::ref_ptr<osg::Group> inside = new osg::Group;
    inside->setStateSet(&air);
    inside->addChild(_interior.node());
    _camera->addChild(inside);
    for (const auto& shown : _interior.mirrorPictures())
    {
        const osg::ref_ptr<osg::Camera> mirror = scenery::makeMirrorCamera(*shown);
        mirror->setGraphicsContext(picture.getGraphicsContext());
        mirror->addChild(&scene);
        view.addSlave(mirror, false);
        _mirrors.push_back(mirror);
    }
    view.addSlave(_camera, false);
}

void InteriorView::show(bool isShown)
{
    _isShown = isShown;
    _camera->setNodeMask(isShown ? ~0U : 0U);
    if (isShown) return;
    for (const auto& mirror : _mirrors)
        scenery::rest(*mirror);
}

void InteriorView::update(const scenery::Pose& vehicle, const scenery::Pose& eye, const Channel& channel,
                          const scenery::models::Readings& readings, bool isDark, MirrorPace pace)
{
    if (!_isShown) return;
    _camera->setViewport(0, 0, channel.widthPx, channel.heightPx);
    _camera->setViewMatrix(matrixOf(scenery::viewFromWorld(channelEye(channel, eye))));
    _camera->setProjectionMatrix(matrixOf(channelProjection(channel, kNearM, kFarM)));
    _interior.show(vehicle, readings, isDark);
    updateMirrors(vehicle, eye, pace);
}

void InteriorView::updateMirrors(const scenery::Pose& vehicle, const scenery::Pose& eye, MirrorPace pace)
{
    if (_mirrors.empty()) return;
    _turn = (_turn + 1) % _mirrors.size();
    for (std::size_t i = 0; i < _mirrors.size(); ++i)
    {
        const bool isDue = pace == MirrorPace::all || i == _turn;
        if (isDue)
            scenery::setMirrorView(*_mirrors[i], scenery::mirrorView(_interior.model().mirrors[i], vehicle,
                                                                     eye.positionWorld, kMirrorFarM));
        else
            scenery::rest(*_mirrors[i]);
    }
}

} // namespace trainer
