// SPDX-License-Identifier: Apache-2.0
#include "measurement/light/view/CloudViews.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <osg/Uniform>

#include "measurement/light/view/GreyBox.h"
#include "scenery/nodes/Pose.h"
#include "scenery/nodes/Sky.h"

namespace measurement
{

namespace
{

constexpr int kViewWidePx = 48, kViewHighPx = 36;
constexpr double kMastAwayM = 1000.0, kClimbMarginM = 150.0;

int levelAt(const osg::Image& picture, int x, int y)
{
    const unsigned char* const pixel = picture.data(static_cast<unsigned>(x), static_cast<unsigned>(y));
    return pixel[0] + pixel[1] + pixel[2];
}

} // namespace

foundation::Result<std::unique_ptr<CloudViews>> CloudViews::create(std::function<double(double)> greyUnder)
{
    osgOffscreen::OffscreenSettings settings;
    settings.widthPx = kViewWidePx;
    settings.heightPx = kViewHighPx;
    auto viewer = osgOffscreen::OffscreenViewer::create(settings);
    if (!viewer) return viewer.error();
    return std::unique_ptr<CloudViews>(new CloudViews(std::move(greyUnder), std::move(*viewer)));
}

CloudViews::CloudViews(std::function<double(double)> greyUnder,
                       std::unique_ptr<osgOffscreen::OffscreenViewer> viewer)
    : _greyUnder(std::move(greyUnder)),
      _atmosphere(new osgSky::Atmosphere),
      _root(new osg::Group),
      _mast(new osg::MatrixTransform),
      _viewer(std::move(viewer))
{
    _root->setStateSet(_atmosphere->stateSet());
    _root->addChild(scenery::makeSky());
    _root->addChild(greyPlain());
    _mast->addChild(greyBox({-100.0F, -1.0F, 0.0F}, {100.0F, 1.0F, 12000.0F}, 0.0F));
    _mast->setMatrix(osg::Matrixd::translate(0.0, kMastAwayM, 0.0));
    _root->addChild(_mast);
    _clouds.setDetail(1, 128);
    _root->addChild(&_clouds.node());
    _viewer->viewer().setSceneData(_root);
}

void CloudViews::setLayer(const simulation::CloudLayer& layer)
{
    _layer = layer;
    _clouds.setLayers({layer}, 0.0);
}

osg::ref_ptr<osg::Image> CloudViews::look(const glm::dvec3& eye, const glm::dvec3& ahead, double highDeg)
{
    osgSky::AtmosphereSettings air;
    air.sunDirectionWorld = osgSky::sunDirectionFromAngles(160.0, 45.0);
    _clouds.show(air.sunDirectionWorld, osgSky::atmosphereLight(air).sun, {0.0, 0.0});
    air.cloudCover = _greyUnder(_clouds.coverAbove(eye.z)); // as a scene does
    static_cast<void>(_atmosphere->setSettings(air));       // made from numbers in range
    if (_sky)
        for (const char* name : {"atmosphereZenith", "atmosphereHorizon"})
            _atmosphere->stateSet()->getUniform(name)->set(*_sky);
    _viewer->camera().setProjectionMatrixAsPerspective(
        highDeg, static_cast<double>(kViewWidePx) / kViewHighPx, 0.5, 2e5);
    const glm::dmat4 view = scenery::viewFromWorld(scenery::poseLookingAt(eye, eye + ahead));
    _viewer->camera().setViewMatrix(osg::Matrixd(&view[0][0]));
    return _viewer->picture();
}

double CloudViews::drawnOktas()
{
    constexpr int kPlaces = 12;
    constexpr double kApartM = scenery::clouds::CloudVolume::kTileM / kPlaces, kHighDeg = 8.0;
    constexpr double kSeenThrough = 0.9; // of a cloud of depth 0.1
    _mast->setNodeMask(0U);
    // A black and a white sky: what is left of their difference comes through the clouds.
    const auto difference = [&](const glm::dvec3& eye, int y)
    {
        int levels[2];
        for (const bool isWhite : {false, true})
        {
            _sky = isWhite ? osg::Vec3f(1.0F, 1.0F, 1.0F) : osg::Vec3f();
            levels[isWhite ? 1 : 0] = levelAt(*look(eye, {0.0, 1e-3, 1.0}, kHighDeg), kViewWidePx / 2, y);
        }
        return static_cast<double>(levels[1] - levels[0]);
    };
    const unsigned shown = _clouds.node().getNodeMask();
    _clouds.node().setNodeMask(0U);
    const double clear = difference({0.0, 0.0, 2.0}, kViewHighPx / 2);
    _clouds.node().setNodeMask(shown);
    int cloudy = 0, all = 0;
    for (int row = 0; row < kPlaces; ++row)
        for (int column = 0; column < kPlaces; ++column)
            for (int y = 4; y < kViewHighPx; y += 12, ++all)
                cloudy += difference({kApartM * column, kApartM * row, 2.0}, y) < kSeenThrough * clear;
    _sky.reset();
    return 8.0 * cloudy / all;
}

double CloudViews::drawnBaseM()
{
    constexpr double kHighDeg = 30.0;
    _mast->setNodeMask(~0U);
    const auto contrastAt = [&](double heightM)
    {
        const osg::ref_ptr<osg::Image> picture = look({0.0, 0.0, heightM}, {0.0, 1.0, 0.0}, kHighDeg);
        const int mast = levelAt(*picture, kViewWidePx / 2, kViewHighPx / 2),
                  sky = levelAt(*picture, 2, kViewHighPx / 2);
        return static_cast<double>(sky - mast) / std::max(sky, 1);
    };
    const double clear = contrastAt(_layer.baseM - 100.0);
    for (double heightM = _layer.baseM - 100.0; heightM < _layer.topM; heightM += 2.0)
        if (contrastAt(heightM) < 0.5 * clear) return heightM;
    return std::nan("");
}

std::vector<double> CloudViews::climb()
{
    constexpr int kSteps = 200;
    _mast->setNodeMask(0U);
    std::vector<double> levels;
    const double from = _layer.baseM - kClimbMarginM, to = _layer.topM + kClimbMarginM;
    for (int i = 0; i <= kSteps; ++i)
    {
        const osg::ref_ptr<osg::Image> picture =
            look({0.0, 0.0, from + (to - from) * i / kSteps}, {0.0, 1.0, 0.0}, 40.0);
        double sum = 0.0;
        for (int y = 0; y < kViewHighPx; ++y)
            for (int x = 0; x < kViewWidePx; ++x)
                sum += levelAt(*picture, x, y) / 3.0;
        levels.push_back(sum / (kViewWidePx * kViewHighPx));
    }
    return levels;
}

} // namespace measurement
