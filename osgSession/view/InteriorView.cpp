// SPDX-License-Identifier: Apache-2.0
#include "view/InteriorView.h"

#include <algorithm>

#include "scenery/nodes/MirrorCamera.h"

namespace trainer
{

namespace
{

constexpr double kNearM = 0.05, kFarM = 60.0; ///< to the tip of a wing
constexpr double kMirrorFarM = 20'000.0;
constexpr int kAfterMirrors = 5;
constexpr int kAfterPicture = 5; ///< before what is drawn over it (hud)
constexpr int kCovered = 1;      ///< in the stencil: by the inside

osg::Matrixd matrixOf(const glm::dmat4& matrix)
{
    return osg::Matrixd(&matrix[0][0]); // GLM's columns are OSG's rows
}

osg::ref_ptr<osg::Camera> makeCamera(const char* name)
{
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setName(name);
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
    camera->setProjectionResizePolicy(osg::Camera::FIXED);
    camera->setAllowEventFocus(false);
    return camera;
}

/// Marks what is drawn.
osg::ref_ptr<osg::Stencil> covering()
{
    osg::ref_ptr<osg::Stencil> stencil = new osg::Stencil;
    stencil->setFunction(osg::Stencil::ALWAYS, kCovered, ~0U);
    stencil->setOperation(osg::Stencil::KEEP, osg::Stencil::KEEP, osg::Stencil::REPLACE);
    return stencil;
}

/// Draws where nothing is marked.
osg::ref_ptr<osg::Stencil> uncovered()
{
    osg::ref_ptr<osg::Stencil> stencil = new osg::Stencil;
    stencil->setFunction(osg::Stencil::NOTEQUAL, kCovered, ~0U);
    stencil->setOperation(osg::Stencil::KEEP, osg::Stencil::KEEP, osg::Stencil::KEEP);
    stencil->setWriteMask(0);
    return stencil;
}

} // namespace

std::unique_ptr<InteriorView> InteriorView::create(const scenery::models::EntityShape& shape,
                                                   const glm::dvec3& eyeInBody)
{
    auto model = scenery::models::makeInterior(shape, eyeInBody);
    return model ? std::unique_ptr<InteriorView>(new InteriorView(std::move(*model))) : nullptr;
}

InteriorView::InteriorView(scenery::models::InteriorModel model)
    : _interior(std::move(model)), _camera(makeCamera("interior")), _disc(makeCamera("propeller disc"))
{
    _camera->setRenderOrder(osg::Camera::PRE_RENDER, kAfterMirrors);
    _disc->setRenderOrder(osg::Camera::POST_RENDER, kAfterPicture);
    _disc->setClearMask(0);
    // The depths of the picture are those of another near plane.
    _disc->getOrCreateStateSet()->setMode(GL_DEPTH_TEST,
                                          osg::StateAttribute::OFF | osg::StateAttribute::OVERRIDE);
}

void InteriorView::addCamera(osgViewer::View& view, osg::Camera& camera, osg::Node& shown,
                             osg::Stencil& stencil, osg::StateSet& air)
{
    camera.setGraphicsContext(_picture->getGraphicsContext());
    camera.getOrCreateStateSet()->setAttributeAndModes(&stencil);
    // Not the camera's own: a camera keeps its viewport in its state.
    const osg::ref_ptr<osg::Group> lit = new osg::Group;
    lit->setStateSet(&air);
    lit->addChild(&shown);
    camera.addChild(lit);
    view.addSlave(&camera, false);
}

void InteriorView::addTo(osgViewer::View& view, osg::Camera& picture, osg::StateSet& air, osg::Node& scene)
{
    _picture = &picture;
    for (const auto& shown : _interior.mirrorPictures())
    {
        const osg::ref_ptr<osg::Camera> mirror = scenery::makeMirrorCamera(*shown);
        mirror->setGraphicsContext(picture.getGraphicsContext());
        mirror->addChild(&scene);
        view.addSlave(mirror, false);
        _mirrors.push_back(mirror);
    }
    _camera->setClearColor(picture.getClearColor());
    addCamera(view, *_camera, *_interior.node(), *covering(), air);
    const osg::ref_ptr<osg::Stencil> free = uncovered();
    if (_interior.disc()) addCamera(view, *_disc, *_interior.disc(), *free, air);
    picture.getOrCreateStateSet()->setAttribute(free);
    showInside(_isShown);
}

void InteriorView::show(bool isShown)
{
    _isShown = isShown;
    showInside(isShown);
    if (!isShown) restMirrors();
}

/// The first that is drawn into the picture clears it.
void InteriorView::showInside(bool isShown)
{
    constexpr GLbitfield kAll = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
    _camera->setNodeMask(isShown ? ~0U : 0U);
    _camera->setClearMask(isShown ? kAll | GL_STENCIL_BUFFER_BIT : 0);
    _disc->setNodeMask(isShown ? ~0U : 0U);
    _picture->setClearMask(isShown ? GL_DEPTH_BUFFER_BIT : kAll);
    _picture->getOrCreateStateSet()->setMode(GL_STENCIL_TEST,
                                             isShown ? osg::StateAttribute::ON : osg::StateAttribute::OFF);
}

void InteriorView::restMirrors()
{
    for (const auto& mirror : _mirrors)
        scenery::rest(*mirror);
}

void InteriorView::update(const scenery::Pose& vehicle, const scenery::Pose& eye, const Channel& channel,
                          const scenery::models::Readings& readings, bool isDark, MirrorPace pace)
{
    if (!_isShown) return;
    const glm::dmat4 view = scenery::viewFromWorld(channelEye(channel, eye)),
                     projection = channelProjection(channel, kNearM, kFarM);
    for (osg::Camera* const camera : {_camera.get(), _disc.get()})
    {
        camera->setViewport(new osg::Viewport(*_picture->getViewport()));
        camera->setViewMatrix(matrixOf(view));
        camera->setProjectionMatrix(matrixOf(projection));
    }
    _interior.show(vehicle, readings, isDark);
    updateMirrors(vehicle, eye, projection * view, pace);
}

/// Which mirrors are drawn anew; those that the picture does not show are none of them.
std::vector<bool> InteriorView::dueMirrors(const scenery::Pose& vehicle, const glm::dmat4& clipFromWorld,
                                           MirrorPace pace)
{
    std::vector<bool> due;
    for (const auto& mirror : _interior.model().mirrors)
        due.push_back(scenery::isInPicture(mirror, vehicle, clipFromWorld));
    if (pace == MirrorPace::all || std::find(due.begin(), due.end(), true) == due.end()) return due;
    do
        _turn = (_turn + 1) % due.size();
    while (!due[_turn]);
    due.assign(due.size(), false);
    due[_turn] = true;
    return due;
}

void InteriorView::updateMirrors(const scenery::Pose& vehicle, const scenery::Pose& eye,
                                 const glm::dmat4& clipFromWorld, MirrorPace pace)
{
    const std::vector<bool> due = dueMirrors(vehicle, clipFromWorld, pace);
    for (std::size_t i = 0; i < _mirrors.size(); ++i)
    {
        if (due[i])
            scenery::setMirrorView(*_mirrors[i], scenery::mirrorView(_interior.model().mirrors[i], vehicle,
                                                                     eye.positionWorld, kMirrorFarM));
        else
            scenery::rest(*_mirrors[i]);
    }
}

} // namespace trainer
