// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <osg/Math>

#include "measurement/light/view/CloudViews.h"
#include "measurement/light/view/DrawnFigures.h"
#include "measurement/light/view/SkyPictures.h"
#include "scenery/lights/Allard.h"

namespace measurement
{

namespace
{

double meanOf(const std::vector<double>& levels)
{
    return std::accumulate(levels.begin(), levels.end(), 0.0) / static_cast<double>(levels.size());
}

/// Adds the step, the sense and the darkest of a sweep.
void addSweep(LightFigures& figures, const std::string& name, const SkySweep& seen)
{
    figures.push_back(atMost("N9", name + ": largest of 200 steps over the mean",
                             kPercent * largestStep(seen.levels) / meanOf(seen.levels), "%", 2.0,
                             "goal of this project"));
    LightFigure darkest;
    darkest.goal = "N9";
    darkest.name = name + ": darkest level of the sky";
    darkest.value = 255.0 * *std::min_element(seen.levels.begin(), seen.levels.end());
    darkest.unit = "of 255";
    darkest.least = 1.0;
    darkest.source = "never black";
    figures.push_back(darkest);
}

/// The light of level ground by sun and sky, or by moon and sky.
double levelLight(double sunDeg, double moonlight)
{
    osgSky::AtmosphereSettings air;
    air.sunDirectionWorld = osgSky::sunDirectionFromAngles(180.0, sunDeg);
    air.moonlight = moonlight;
    const osgSky::AtmosphereLight light = osgSky::atmosphereLight(air);
    const double sine = std::max(std::sin(osg::DegreesToRadians(sunDeg)), 0.0);
    const osg::Vec3f level = light.sun * static_cast<float>(sine) + light.sky;
    return 0.2126 * level.x() + 0.7152 * level.y() + 0.0722 * level.z();
}

/// By what factor one number is off another, whichever is larger.
double factor(double value, double wanted)
{
    return std::max(value / wanted, wanted / value);
}

/// The light of level ground against measured daylight and moonlight, all over that of a sun of 60 degrees.
void addLevels(LightFigures& figures)
{
    constexpr double kNoonDeg = 60.0, kMost = 1.5, kFullMoon = 1e-6, kStarlight = 1e-8;
    const char* const kNatural = "Biberman 1971, after Brown 1952: 1e4, 1e-2 and 1e-4 foot-candles";
    const char* const kDaylight = "Bond and Henderson 1963";
    const double noon = levelLight(kNoonDeg, 0.0), noonKnown = scenery::backgroundCdM2(kNoonDeg, 0.0);
    const auto worst = [&](std::initializer_list<double> sunsDeg)
    {
        double most = 1.0;
        for (const double deg : sunsDeg)
            most = std::max(
                most, factor(levelLight(deg, 0.0) / noon, scenery::backgroundCdM2(deg, 0.0) / noonKnown));
        return most;
    };
    figures.push_back(atMost("N10", "level ground, sun 15 to 90 deg: factor off", worst({15.0, 35.0, 90.0}),
                             "", kMost, kDaylight));
    figures.push_back(atMost("N10", "level ground, sun -6 to 5 deg: factor off",
                             worst({-6.0, -3.0, 0.0, 5.0}), "", kMost, kDaylight));
    figures.push_back(atMost("N10", "level ground under a full moon: factor off",
                             factor(levelLight(-30.0, 1.0) / noon, kFullMoon), "", kMost, kNatural));
    figures.push_back(atMost("N10", "level ground under stars: factor off",
                             factor(levelLight(-30.0, 0.0) / noon, kStarlight), "", kMost, kNatural));
}

} // namespace

foundation::Result<LightFigures> drawnSkyFigures()
{
    const auto made = SkyPictures::create();
    if (!made) return made.error();
    const glm::dvec3 north(0.0, 1.0, 0.0), east(1.0, 0.0, 0.6);
    LightFigures figures;
    for (const auto& [name, towards] : {std::pair{"sun from -20 to 90 deg, to the north", north},
                                        std::pair{"sun from -20 to 90 deg, to the east", east}})
    {
        const SkySweep seen = (*made)->sweep(sunAtShare, towards);
        addSweep(figures, name, seen);
        figures.push_back(atMost("N9", std::string(name) + ": deepest fall of light to 35 deg",
                                 kPercent * deepestFall(seen.lights, 0.0, shareOfSun(35.0)), "%", 2.0,
                                 "more sun, more light; pixels are rounded"));
    }
    const auto sweepOf = [&](const char* name, auto&& change)
    {
        addSweep(figures, name,
                 (*made)->sweep(
                     [&](double share)
                     {
                         osgSky::AtmosphereSettings air;
                         change(air, share);
                         return air;
                     },
                     north));
    };
    sweepOf("visibility from 0.1 to 60 km", [](osgSky::AtmosphereSettings& air, double share)
            { air.visibilityM = 100.0 * std::pow(600.0, share); });
    sweepOf("cover from 0 to 1",
            [](osgSky::AtmosphereSettings& air, double share) { air.cloudCover = share; });
    addLevels(figures);
    return figures;
}

foundation::Result<LightFigures> drawnCloudFigures(const SceneParts& scenes)
{
    using simulation::CloudKind;
    const auto made = CloudViews::create(scenes.greyUnder);
    if (!made) return made.error();
    CloudViews& views = **made;
    LightFigures figures;
    const simulation::CloudLayer cumulus{CloudKind::cumulus, 4, 1200.0, 2000.0},
        heaps{CloudKind::stratocumulus, 6, 1000.0, 1500.0}, sheet{CloudKind::stratus, 8, 600.0, 1000.0};
    for (const auto& [name, layer] :
         {std::pair{"cumulus of 4 oktas", cumulus}, std::pair{"stratocumulus of 6 oktas", heaps},
          std::pair{"stratus of 8 oktas", sheet}})
    {
        views.setLayer(layer);
        figures.push_back(atMost("N7", std::string(name) + " in pictures: cover",
                                 std::abs(views.drawnOktas() - layer.oktas), "oktas", 0.5,
                                 "the layer's oktas"));
    }
    figures.push_back(atMost("N7", "stratus of 8 oktas in pictures: base",
                             std::abs(views.drawnBaseM() - sheet.baseM), "m", 20.0, "the layer's base"));
    const std::vector<double> levels = views.climb();
    figures.push_back(atMost("N7", "climb through stratus: largest of 200 steps over the mean",
                             kPercent * largestStep(levels) / meanOf(levels), "%", 3.0,
                             "goal of this project"));
    return figures;
}

} // namespace measurement
