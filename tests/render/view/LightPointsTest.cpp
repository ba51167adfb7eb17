// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/LightPoints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>

#include <gtest/gtest.h>

#include "RenderedPicture.h"
#include "scenery/lights/Allard.h"

using scenery::BeamKind;
using scenery::LightPoint;

namespace
{

constexpr int kSidePx = 32;
constexpr double kNightLx = 8e-7;
constexpr double kHighDeg = 4.0; ///< of the picture

scenery::LightLevels full()
{
    scenery::LightLevels levels{};
    levels.fill(1.0F);
    return levels;
}

struct Sight
{
    glm::dvec3 eye{-1000.0, 0.0, 0.0};
    double visibilityM = 60000.0;
    double leastLx = kNightLx;
    double timeS = 0.0;
    int samples = 1;
    glm::dvec2 asidePx{0.0}; ///< how far the first light stands off the middle of the picture
    scenery::LightLevels levels = full();
};

/// Lights before black, and a viewer that looks at the first one; for many pictures.
class Scene
{
public:
    Scene(const std::vector<LightPoint>& lights, int samples)
        : _atmosphere(new osgSky::Atmosphere),
          _root(new osg::Group),
          _at(lights.front().place),
          _uniforms(*stateOf(*_root, *_atmosphere)),
          _points(lights)
    {
        _root->addChild(_points.node());
        osgOffscreen::OffscreenSettings settings;
        settings.backend = osgOffscreen::defaultBackend();
        settings.widthPx = settings.heightPx = kSidePx;
        settings.samples = samples;
        auto made = osgOffscreen::OffscreenViewer::create(settings);
        if (!made) throw std::runtime_error(made.error().message());
        _viewer = std::move(*made);
        _viewer->viewer().setSceneData(_root);
        _viewer->camera().setClearColor({0.0F, 0.0F, 0.0F, 1.0F});
    }

    osg::ref_ptr<osg::Image> picture(const Sight& sight)
    {
        osgSky::AtmosphereSettings air;
        air.visibilityM = sight.visibilityM;
        air.hazeBaseM = 1e5;
        air.sunDirectionWorld = {0.0, -0.5, -1.0};
        EXPECT_TRUE(_atmosphere->setSettings(air));
        _uniforms.show(sight.leastLx, sight.timeS, sight.timeS, sight.levels);
        _points.light(sight.levels);
        osg::Matrixd projection = osg::Matrixd::perspective(kHighDeg, 1.0, 0.5, 2e5);
        projection.postMult(
            osg::Matrixd::translate(2.0 * sight.asidePx.x / kSidePx, 2.0 * sight.asidePx.y / kSidePx, 0.0));
        _viewer->camera().setProjectionMatrix(projection);
        _viewer->camera().setViewMatrixAsLookAt({sight.eye.x, sight.eye.y, sight.eye.z},
                                                {_at.x, _at.y, _at.z}, {0, 0, 1});
        return _viewer->picture();
    }

private:
    static osg::StateSet* stateOf(osg::Group& root, const osgSky::Atmosphere& atmosphere)
    {
        atmosphere.addUniformsTo(*root.getOrCreateStateSet());
        return root.getStateSet();
    }

    osg::ref_ptr<osgSky::Atmosphere> _atmosphere;
    osg::ref_ptr<osg::Group> _root;
    glm::dvec3 _at;
    scenery::LightUniforms _uniforms;
    scenery::LightPoints _points;
    std::unique_ptr<osgOffscreen::OffscreenViewer> _viewer;
};

osg::ref_ptr<osg::Image> pictureOf(const std::vector<LightPoint>& lights, const Sight& sight)
{
    return Scene(lights, sight.samples).picture(sight);
}

int brightest(const osg::Image& image, int channel = 1)
{
    int most = 0;
    for (int y = 0; y < image.t(); ++y)
        for (int x = 0; x < image.s(); ++x)
            most =
                std::max<int>(most, image.data(static_cast<unsigned>(x), static_cast<unsigned>(y))[channel]);
    return most;
}

/// The sum over all pixels, in linear light: the inverse of displayColour().
double fluxOf(const osg::Image& image, int channel = 1)
{
    double sum = 0.0;
    for (int y = 0; y < image.t(); ++y)
        for (int x = 0; x < image.s(); ++x)
        {
            const double shown =
                image.data(static_cast<unsigned>(x), static_cast<unsigned>(y))[channel] / 255.0;
            sum += std::pow(-std::log(1.0 - std::min(shown * shown, 0.9999)), 1.0 / 1.125);
        }
    return sum;
}

/// The distance from which a lamp shows in the picture, by halving.
double rangeInPictureM(double candela, double visibilityM, double leastLx)
{
    LightPoint light;
    light.candela = candela;
    Scene scene({light}, 1);
    double low = 100.0, high = 60000.0;
    while (high / low > 1.004)
    {
        const double middle = std::sqrt(low * high);
        Sight sight;
        sight.eye = {-middle, 0.0, 0.0};
        sight.visibilityM = visibilityM;
        sight.leastLx = leastLx;
        (brightest(*scene.picture(sight)) > 0 ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

/// Least and greatest flux over mean, over 64 places within a pixel.
std::array<double, 2> fluxOverPlaces(double candela, int samples,
                                     const std::function<double(const osg::Image&)>& flux)
{
    LightPoint light;
    light.candela = candela;
    Scene scene({light}, samples);
    double least = 1e9, most = 0.0, sum = 0.0;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
        {
            Sight sight;
            sight.asidePx = {x / 8.0, y / 8.0};
            const double now = flux(*scene.picture(sight));
            least = std::min(least, now);
            most = std::max(most, now);
            sum += now / 64.0;
        }
    return {least / sum, most / sum};
}

} // namespace

TEST(LightPoints, AreFirstSeenWhereAllardsLawSays)
{
    struct Row
    {
        double candela, visibilityKm, leastLx, rangeKm;
    };
    for (const Row& row : {Row{1000, 1.5, 8e-7, 2.61},
                           {1000, 50, 8e-7, 19.6},
                           {10000, 5, 8e-7, 8.57},
                           {10000, 10, 1e-5, 8.65},
                           {20000, 50, 1e-4, 10.4}})
        EXPECT_NEAR(rangeInPictureM(row.candela, 1000.0 * row.visibilityKm, row.leastLx),
                    1000.0 * row.rangeKm, 30.0 * row.rangeKm)
            << row.candela << " cd in " << row.visibilityKm << " km";
    EXPECT_GT(std::abs(rangeInPictureM(1000.0, 1800.0, 8e-7) - 2610.0), 0.03 * 2610.0)
        << "air that is too clear";
}

TEST(LightPoints, KeepTheirFluxWhereverTheyFallBetweenPixels)
{
    const auto all = [](const osg::Image& image) { return fluxOf(image); };
    for (const int samples : {1, 4})
        for (const double candela : {300.0, 700.0})
        {
            const auto [least, most] = fluxOverPlaces(candela, samples, all);
            const double within = samples == 1 ? 0.02 : 0.03; // edges of points cut samples
            EXPECT_GT(least, 1.0 - within) << candela << " cd, samples " << samples;
            EXPECT_LT(most, 1.0 + within) << candela << " cd, samples " << samples;
        }
    // What a point without a spread would do: its light is that of one pixel.
    const auto [least, most] = fluxOverPlaces(
        300.0, 1, [](const osg::Image& image) { return std::pow(brightest(image) / 255.0, 1.78); });
    EXPECT_GT(most / least, 1.5);
}

TEST(LightPoints, TheirFluxFollowsIntensityDistanceAndSteps)
{
    LightPoint light;
    light.candela = 200.0;
    light.group = scenery::LightGroup::approach;
    Sight sight;
    sight.visibilityM = 1e7;
    const double one = fluxOf(*pictureOf({light}, sight));
    light.candela = 400.0;
    EXPECT_NEAR(fluxOf(*pictureOf({light}, sight)) / one, 2.0, 0.04);
    sight.eye = {-2000.0, 0.0, 0.0};
    EXPECT_NEAR(fluxOf(*pictureOf({light}, sight)) / one, 0.5, 0.01);
    sight.eye = {-1000.0, 0.0, 0.0};
    sight.levels[static_cast<std::size_t>(scenery::LightGroup::approach)] = 0.25F;
    EXPECT_NEAR(fluxOf(*pictureOf({light}, sight)) / one, 0.5, 0.01);
    sight.levels[static_cast<std::size_t>(scenery::LightGroup::approach)] = 0.0F;
    EXPECT_EQ(brightest(*pictureOf({light}, sight)), 0) << "nothing beside lamps is but black";
}

TEST(LightPoints, ShineIntoTheirBeamAsTheValuesSay)
{
    LightPoint light;
    light.candela = 2000.0;
    for (const BeamKind kind : {BeamKind::forwardLeft, BeamKind::streetLamp, BeamKind::runwayEdge})
        for (const double asideDeg : {-150.0, -30.0, 5.0, 15.0, 60.0, 170.0})
            for (const double upDeg : {-12.0, 2.0, 33.0})
            {
                light.beam = kind;
                light.headingDeg = 20.0;
                Sight sight;
                const double a = glm::radians(asideDeg + 20.0), u = glm::radians(upDeg);
                sight.eye =
                    1000.0 * glm::dvec3(std::cos(u) * std::cos(a), std::cos(u) * std::sin(a), std::sin(u));
                LightPoint plain;
                plain.candela = std::max(candelaTowards(light, sight.eye, 0.0), 1e-6);
                EXPECT_NEAR(fluxOf(*pictureOf({light}, sight)), fluxOf(*pictureOf({plain}, sight)),
                            0.03 * fluxOf(*pictureOf({plain}, sight)) + 1e-4)
                    << static_cast<int>(kind) << ' ' << asideDeg << ' ' << upDeg;
            }
}

TEST(LightPoints, ChangeTheirColourWithinThreeMinutesOfArc)
{
    LightPoint unit;
    unit.candela = 15000.0;
    unit.tiltDeg = 3.0;
    unit.headingDeg = 180.0;
    unit.beam = BeamKind::papi;
    unit.below = scenery::ColourBelow{{1.0F, 0.0F, 0.0F}, 3.0};
    std::unique_ptr<Scene> scene = std::make_unique<Scene>(std::vector{unit}, 1);
    const auto whiteAt = [&](double deg)
    {
        Sight sight;
        sight.eye = {-6000.0, 0.0, 6000.0 * std::tan(glm::radians(deg))};
        const auto image = scene->picture(sight);
        return fluxOf(*image, 1) / std::max(fluxOf(*image, 0), 1e-9);
    };
    const auto angleOf = [&](double share)
    {
        double low = unit.below->angleDeg - 0.2, high = unit.below->angleDeg + 0.2;
        while (high - low > 1e-4)
            (whiteAt(0.5 * (low + high)) < share ? low : high) = 0.5 * (low + high);
        return 0.5 * (low + high);
    };
    const double width = 60.0 * (angleOf(0.98) - angleOf(0.02));
    EXPECT_LT(width, 3.0) << "minutes";
    EXPECT_GT(width, 1.0);
    EXPECT_NEAR(60.0 * (angleOf(0.5) - 3.0), 0.0, 0.5) << "minutes";
    unit.below->angleDeg = 3.02;
    scene = std::make_unique<Scene>(std::vector{unit}, 1);
    EXPECT_GT(60.0 * (angleOf(0.5) - 3.0), 0.5) << "a unit that is set wrong";
}

TEST(LightPoints, FlashByTheTimeThatIsShown)
{
    LightPoint light;
    light.candela = 400.0;
    light.flash = {1.0, 0.25, 0.1};
    for (const double timeS : {0.0, 0.3, 0.5, 1.3, 100.3, 100.4})
    {
        Sight sight;
        sight.timeS = timeS;
        EXPECT_EQ(brightest(*pictureOf({light}, sight)) > 0, isLit(light.flash, timeS)) << timeS;
    }
}
