// SPDX-License-Identifier: Apache-2.0
#include "measurement/light/view/SkyPictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "measurement/light/view/GreyBox.h"
#include "measurement/light/view/ShownLight.h"
#include "scenery/nodes/Pose.h"
#include "scenery/nodes/Sky.h"

namespace measurement
{

namespace
{

constexpr double kLowestSunDeg = -20.0, kHighestSunDeg = 90.0;

/// Mean luminance of the upper half of a picture, 0 … 1.
double upperLuminance(const osg::Image& picture)
{
    double sum = 0.0;
    for (int y = picture.t() / 2; y < picture.t(); ++y)
        for (int x = 0; x < picture.s(); ++x)
        {
            const unsigned char* pixel = picture.data(static_cast<unsigned>(x), static_cast<unsigned>(y));
            sum += 0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2];
        }
    return sum / (255.0 * picture.s() * (picture.t() - picture.t() / 2));
}

} // namespace

foundation::Result<std::unique_ptr<SkyPictures>> SkyPictures::create()
{
    osgOffscreen::OffscreenSettings settings;
    settings.widthPx = 48;
    settings.heightPx = 36;
    auto viewer = osgOffscreen::OffscreenViewer::create(settings);
    if (!viewer) return viewer.error();
    return std::unique_ptr<SkyPictures>(new SkyPictures(std::move(*viewer)));
}

SkyPictures::SkyPictures(std::unique_ptr<osgOffscreen::OffscreenViewer> viewer)
    : _atmosphere(new osgSky::Atmosphere), _root(new osg::Group), _viewer(std::move(viewer))
{
    _root->setStateSet(_atmosphere->stateSet());
    _root->addChild(scenery::makeSky());
    _root->addChild(greyPlain());
    _viewer->viewer().setSceneData(_root);
    _viewer->camera().setProjectionMatrixAsPerspective(60.0, 4.0 / 3.0, 0.5, 2e5);
}

SkySweep SkyPictures::sweep(const std::function<osgSky::AtmosphereSettings(double)>& settingsAt,
                            const glm::dvec3& towards)
{
    const glm::dvec3 eye(0.0, 0.0, 50.0);
    const glm::dmat4 view = scenery::viewFromWorld(scenery::poseLookingAt(eye, eye + towards));
    _viewer->camera().setViewMatrix(osg::Matrixd(&view[0][0]));
    SkySweep seen;
    for (int i = 0; i <= kSteps; ++i)
    {
        const foundation::Outcome set = _atmosphere->setSettings(settingsAt(static_cast<double>(i) / kSteps));
        const double level = set ? upperLuminance(*_viewer->picture()) : std::nan("");
        seen.levels.push_back(level);
        seen.lights.push_back(exposedOf(level) / _atmosphere->light().exposure);
    }
    return seen;
}

double largestStep(const std::vector<double>& levels)
{
    double largest = 0.0;
    for (std::size_t i = 0; i + 1 < levels.size(); ++i)
    {
        const double step = std::abs(levels[i + 1] - levels[i]);
        largest = step <= largest ? largest : step;
    }
    return largest;
}

double deepestFall(const std::vector<double>& levels, double fromShare, double toShare)
{
    const auto last = static_cast<double>(levels.size() - 1);
    double highest = 0.0, deepest = 0.0;
    for (auto i = static_cast<std::size_t>(fromShare * last); i <= static_cast<std::size_t>(toShare * last);
         ++i)
    {
        highest = std::max(highest, levels.at(i));
        deepest = std::max(deepest, 1.0 - levels.at(i) / highest);
    }
    return deepest;
}

osgSky::AtmosphereSettings sunAtShare(double share)
{
    osgSky::AtmosphereSettings air;
    air.sunDirectionWorld =
        osgSky::sunDirectionFromAngles(180.0, kLowestSunDeg + share * (kHighestSunDeg - kLowestSunDeg));
    return air;
}

double shareOfSun(double elevationDeg)
{
    return (elevationDeg - kLowestSunDeg) / (kHighestSunDeg - kLowestSunDeg);
}

} // namespace measurement
