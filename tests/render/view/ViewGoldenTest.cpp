// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "RenderedDefaultCar.h"
#include "RenderedGolden.h"
#include "RenderedPicture.h"
#include "RenderedView.h"

namespace
{

osgOffscreen::OffscreenSettings settingsOf(osgOffscreen::Backend backend)
{
    osgOffscreen::OffscreenSettings settings;
    settings.backend = backend;
    settings.widthPx = 240;
    settings.heightPx = 135;
    settings.samples = 4;
    return settings;
}

std::string rendererOf(osgOffscreen::Backend backend)
{
    const auto context = osgOffscreen::OffscreenContext::create(settingsOf(backend));
    return context ? (*context)->rendererName() : "";
}

osg::ref_ptr<osg::Image> carPicture(osgOffscreen::Backend backend, double steeringDeg = 12.0)
{
    const rendered::ViewScene scene;
    DefaultCar car;
    simulation::EntityState state;
    state.steeringDeg = steeringDeg;
    car.setState(state);
    scene.root->addChild(car.node());
    return rendered::pictureFrom(scene.root, scenery::poseLookingAt({6.0, -4.0, 2.0}, {1.3, 0.0, 0.6}),
                                 settingsOf(backend));
}

osg::ref_ptr<osg::Image> aircraftPicture(osgOffscreen::Backend backend, float trimRed = 0.1F)
{
    const rendered::ViewScene scene;
    scenery::models::EntityShape shape;
    shape.kind = scenery::models::EntityKind::lightAircraft;
    scenery::models::setDefaultSize(shape);
    shape.red = trimRed;
    shape.green = 0.22F;
    shape.blue = 0.50F;
    scenery::EntityShapes shapes;
    scenery::EntityNode aircraft(shape, shapes);
    simulation::EntityState state;
    state.aircraft.emplace().propellerRadps = 250.0;
    aircraft.setState(state, {});
    scene.root->addChild(aircraft.node());
    return rendered::pictureFrom(scene.root, scenery::poseLookingAt({9.0, -8.0, 3.0}, {-1.0, 0.0, 1.4}),
                                 settingsOf(backend));
}

} // namespace

TEST(ViewGolden, CarAndAircraftAreAsStored)
{
    for (const auto backend : rendered::backends())
    {
        EXPECT_TRUE(rendered::matchesGolden(*carPicture(backend), "view-car", rendererOf(backend)));
        EXPECT_TRUE(rendered::matchesGolden(*aircraftPicture(backend), "view-aircraft", rendererOf(backend)));
    }
}

TEST(EntityLamps, ShineOnlyWhileTheyAreLit)
{
    using Lamp = scenery::models::EntityLamp::Kind;
    const auto redOf = [](bool brakes)
    {
        const rendered::ViewScene scene;
        DefaultCar car;
        scenery::models::LitLamps lit{};
        lit[static_cast<std::size_t>(Lamp::brake)] = brakes;
        car.setState({}, lit);
        scene.root->addChild(car.node());
        const auto picture =
            rendered::pictureFrom(scene.root, scenery::poseLookingAt({-6.0, 0.0, 1.2}, {0.0, 0.0, 0.7}),
                                  settingsOf(osgOffscreen::defaultBackend()));
        int count = 0;
        for (int y = 0; y < picture->t(); ++y)
            for (int x = 0; x < picture->s(); ++x)
            {
                const unsigned char* pixel =
                    picture->data(static_cast<unsigned>(x), static_cast<unsigned>(y));
                count += pixel[0] > 235 && pixel[1] < 120;
            }
        return count;
    };
    EXPECT_EQ(redOf(false), 0);
    EXPECT_GT(redOf(true), 20);
}

namespace
{

/// How much brighter the picture of an aircraft with navigation lights is than without, summed over the
/// picture, by colours.
glm::dvec3 glowSeen(const glm::dvec3& eye, double sunElevationDeg)
{
    const auto pictureWith = [&](bool isLit)
    {
        osgSky::AtmosphereSettings air;
        air.sunDirectionWorld = osgSky::sunDirectionFromAngles(180.0, sunElevationDeg);
        const rendered::ViewScene scene(air);
        scenery::models::EntityShape shape;
        shape.kind = scenery::models::EntityKind::lightAircraft;
        scenery::models::setDefaultSize(shape);
        scenery::EntityShapes shapes;
        scenery::EntityNode aircraft(shape, shapes);
        simulation::EntityState state;
        state.position.z = 50.0;
        state.aircraft.emplace().hasNavigationLights = isLit;
        aircraft.setState(state, scenery::defaultLamps(state, true));
        scene.root->addChild(aircraft.node());
        osgOffscreen::OffscreenSettings settings = settingsOf(osgOffscreen::defaultBackend());
        settings.widthPx = 480;
        settings.heightPx = 270;
        return rendered::pictureFrom(scene.root, scenery::poseLookingAt(eye, {0.0, 0.0, 52.0}), settings);
    };
    const osg::ref_ptr<osg::Image> lit = pictureWith(true), dark = pictureWith(false);
    glm::dvec3 sum(0.0);
    for (int y = 0; y < lit->t(); ++y)
        for (int x = 0; x < lit->s(); ++x)
            for (int c = 0; c < 3; ++c)
                sum[c] += lit->data(static_cast<unsigned>(x), static_cast<unsigned>(y))[c] -
                          dark->data(static_cast<unsigned>(x), static_cast<unsigned>(y))[c];
    return sum;
}

} // namespace

TEST(LampGlow, NavigationLightsShowTheirColoursToTheirSides)
{
    const glm::dvec3 left = glowSeen({60.0, 200.0, 52.0}, -12.0),
                     right = glowSeen({60.0, -200.0, 52.0}, -12.0),
                     behind = glowSeen({-200.0, 0.0, 52.0}, -12.0);
    EXPECT_GT(left.r, 3.0 * left.g + 100.0) << "red on the left";
    EXPECT_GT(right.g, 3.0 * right.r + 100.0) << "green on the right";
    EXPECT_GT(std::min({behind.r, behind.g, behind.b}), 100.0) << "white behind";
    EXPECT_LT(std::abs(behind.r - behind.g), 0.2 * behind.r);
    // From 2 km they are seen as well; by day they are faint.
    EXPECT_GT(glowSeen({600.0, 2000.0, 52.0}, -12.0).r, 60.0);
    EXPECT_LT(glowSeen({60.0, 200.0, 52.0}, 50.0).r, left.r);
}

TEST(ViewGolden, SmallChangesDoNotMatch)
{
    if (rendered::writesGoldens()) GTEST_SKIP() << "goldens are being written";
    const auto backend = osgOffscreen::defaultBackend();
    EXPECT_FALSE(rendered::matchesGolden(*carPicture(backend, 6.0), "view-car", rendererOf(backend)));
    EXPECT_FALSE(
        rendered::matchesGolden(*aircraftPicture(backend, 0.3F), "view-aircraft", rendererOf(backend)));
}
