// SPDX-License-Identifier: Apache-2.0
#include "measurement/light/view/LampPictures.h"

#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

#include "measurement/light/view/ShownLight.h"

namespace measurement
{

namespace
{

constexpr double kHighDeg = 4.0; ///< of the picture

osg::StateSet* litState(osg::Group& root, const osgSky::Atmosphere& atmosphere)
{
    atmosphere.addUniformsTo(*root.getOrCreateStateSet());
    return root.getStateSet();
}

} // namespace

scenery::LightLevels fullLevels()
{
    scenery::LightLevels levels{};
    levels.fill(1.0F);
    return levels;
}

foundation::Result<std::unique_ptr<LampPictures>>
LampPictures::create(const std::vector<scenery::LightPoint>& lights, int samples)
{
    osgOffscreen::OffscreenSettings settings;
    settings.widthPx = settings.heightPx = kSidePx;
    settings.samples = samples;
    auto viewer = osgOffscreen::OffscreenViewer::create(settings);
    if (!viewer) return viewer.error();
    return std::unique_ptr<LampPictures>(new LampPictures(lights, std::move(*viewer)));
}

LampPictures::LampPictures(const std::vector<scenery::LightPoint>& lights,
                           std::unique_ptr<osgOffscreen::OffscreenViewer> viewer)
    : _atmosphere(new osgSky::Atmosphere),
      _root(new osg::Group),
      _at(lights.front().place),
      _uniforms(*litState(*_root, *_atmosphere)),
      _points(lights),
      _viewer(std::move(viewer))
{
    _root->addChild(_points.node());
    _viewer->viewer().setSceneData(_root);
    _viewer->camera().setClearColor({0.0F, 0.0F, 0.0F, 1.0F});
}

osg::ref_ptr<osg::Image> LampPictures::picture(const LampSight& sight)
{
    osgSky::AtmosphereSettings air;
    air.visibilityM = sight.visibilityM;
    air.hazeBaseM = 1e5;
    air.sunDirectionWorld = {0.0, -0.5, -1.0};
    static_cast<void>(_atmosphere->setSettings(air)); // these are sound
    _uniforms.show(sight.leastLx, sight.timeS, sight.timeS, sight.levels);
    _points.light(sight.levels);
    if (_spoil) _spoil(*_root->getStateSet());
    osg::Matrixd projection = osg::Matrixd::perspective(kHighDeg, 1.0, 0.5, 2e5);
    projection.postMult(
        osg::Matrixd::translate(2.0 * sight.asidePx.x / kSidePx, 2.0 * sight.asidePx.y / kSidePx, 0.0));
    _viewer->camera().setProjectionMatrix(projection);
    _viewer->camera().setViewMatrixAsLookAt({sight.eye.x, sight.eye.y, sight.eye.z}, {_at.x, _at.y, _at.z},
                                            {0, 0, 1});
    return _viewer->picture();
}

int brightestLevel(const osg::Image& image, int channel)
{
    int most = 0;
    for (int y = 0; y < image.t(); ++y)
        for (int x = 0; x < image.s(); ++x)
            most =
                std::max<int>(most, image.data(static_cast<unsigned>(x), static_cast<unsigned>(y))[channel]);
    return most;
}

double lightIn(const osg::Image& image, int channel)
{
    double sum = 0.0;
    for (int y = 0; y < image.t(); ++y)
        for (int x = 0; x < image.s(); ++x)
        {
            const double shown =
                image.data(static_cast<unsigned>(x), static_cast<unsigned>(y))[channel] / 255.0;
            sum += exposedOf(shown, 0.9999);
        }
    return sum;
}

double rangeInPictureM(LampPictures& lamps, double visibilityM, double leastLx)
{
    double low = 100.0, high = 60000.0;
    while (high / low > 1.004)
    {
        const double middle = std::sqrt(low * high);
        LampSight sight;
        sight.eye = {-middle, 0.0, 0.0};
        sight.visibilityM = visibilityM;
        sight.leastLx = leastLx;
        (brightestLevel(*lamps.picture(sight)) > 0 ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

std::array<double, 2> spreadOverPlaces(LampPictures& lamps,
                                       const std::function<double(const osg::Image&)>& measure)
{
    constexpr int kAcross = 8;
    double least = 1e9, most = 0.0, sum = 0.0;
    for (int y = 0; y < kAcross; ++y)
        for (int x = 0; x < kAcross; ++x)
        {
            LampSight sight;
            sight.asidePx = {static_cast<double>(x) / kAcross, static_cast<double>(y) / kAcross};
            const double now = measure(*lamps.picture(sight));
            least = std::min(least, now);
            most = std::max(most, now);
            sum += now / (kAcross * kAcross);
        }
    return {least / sum, most / sum};
}

ColourChange colourChange(LampPictures& unit, double expectedDeg)
{
    constexpr double kAwayM = 6000.0, kWithinDeg = 0.2, kFineDeg = 1e-4, kEdge = 0.02;
    const auto whiteAt = [&](double deg)
    {
        LampSight sight;
        sight.eye = {-kAwayM, 0.0, kAwayM * std::tan(glm::radians(deg))};
        const osg::ref_ptr<osg::Image> image = unit.picture(sight);
        return lightIn(*image, 1) / std::max(lightIn(*image, 0), 1e-9);
    };
    // What is red and what is white to this unit: green over red well below and above.
    const double red = whiteAt(expectedDeg - kWithinDeg), white = whiteAt(expectedDeg + kWithinDeg);
    const auto angleOf = [&](double share)
    {
        double low = expectedDeg - kWithinDeg, high = expectedDeg + kWithinDeg;
        while (high - low > kFineDeg)
            (whiteAt(0.5 * (low + high)) < red + share * (white - red) ? low : high) = 0.5 * (low + high);
        return 0.5 * (low + high);
    };
    return {angleOf(0.5), angleOf(1.0 - kEdge) - angleOf(kEdge)};
}

} // namespace measurement
