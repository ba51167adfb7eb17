// SPDX-License-Identifier: Apache-2.0
#include "view/ChannelRig.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace trainer
{

namespace
{

osg::Matrixd toOsg(const glm::dmat4& matrix)
{
    return osg::Matrixd(&matrix[0][0]); // both keep the translation in the last four
}

PicturePlace placeOf(const Channel& channel, int leftPx, double drawnSide)
{
    const auto drawn = [=](int px) { return std::max(static_cast<int>(std::lround(drawnSide * px)), 1); };
    const int drawnLeftPx = drawnSide > 1.0 ? static_cast<int>(std::lround(drawnSide * leftPx)) : leftPx;
    return {leftPx,          drawnLeftPx,     drawn(channel.widthPx), drawn(channel.heightPx),
            channel.widthPx, channel.heightPx};
}

} // namespace

ChannelRig::ChannelRig(osgViewer::View& view, ViewSetup setup,
                       const std::vector<osg::ref_ptr<osg::GraphicsContext>>& contexts)
    : _master(view.getCamera()), _setup(std::move(setup))
{
    assert(contexts.size() == picturesOf(_setup).size());
    const bool isTiled = _setup.layout == ViewSetup::Layout::tiled;
    // Slaves inherit cull settings from it every frame.
    _master->setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
    for (std::size_t i = 0; i < _setup.channels.size(); ++i)
    {
        const Channel& channel = _setup.channels[i];
        const osg::ref_ptr<osg::Camera> camera = new osg::Camera;
        camera->setName(channel.name);
        camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
        camera->setGraphicsContext(contexts[isTiled ? 0 : i]);
        camera->setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
        camera->setProjectionResizePolicy(osg::Camera::FIXED);
        _cameras.push_back(camera);
    }
    for (const auto& camera : _cameras)
        view.addSlave(camera, true);
    for (const auto& camera : _cameras)
        _scaled.emplace_back(view, *camera);
    shape();
}

void ChannelRig::shape()
{
    const bool isTiled = _setup.layout == ViewSetup::Layout::tiled;
    _master->setProjectionMatrix(
        toOsg(channelProjection(_setup.channels.front(), _setup.nearM, _setup.farM)));
    int leftPx = 0;
    for (std::size_t i = 0; i < _cameras.size(); ++i)
    {
        const Channel& channel = _setup.channels[i];
        const PicturePlace place = placeOf(channel, isTiled ? leftPx : 0, _drawnSide);
        _cameras[i]->setViewport(place.drawnLeftPx, 0, place.drawnWidthPx, place.drawnHeightPx);
        _cameras[i]->getOrCreateStateSet()->addUniform(
            new osg::Uniform("drawnPixels", static_cast<float>(std::max(std::ceil(_drawnSide), 1.0))),
            osg::StateAttribute::OVERRIDE);
        _scaled[i].fit(place);
        _cameras[i]->setProjectionMatrix(toOsg(channelProjection(channel, _setup.nearM, _setup.farM)));
        leftPx += channel.widthPx;
    }
}

void ChannelRig::reshape(ViewSetup setup)
{
    assert(setup.channels.size() == _cameras.size());
    _setup = std::move(setup);
    shape();
}

void ChannelRig::setDrawnSide(double share)
{
    if (share == _drawnSide) return;
    _drawnSide = share;
    shape();
}

void ChannelRig::setEye(const scenery::Pose& eye)
{
    _master->setViewMatrix(toOsg(scenery::viewFromWorld(eye)));
    for (std::size_t i = 0; i < _cameras.size(); ++i)
        _cameras[i]->setViewMatrix(toOsg(scenery::viewFromWorld(channelEye(_setup.channels[i], eye))));
}

} // namespace trainer
