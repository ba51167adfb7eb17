// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "RenderedGolden.h"
#include "RenderedPicture.h"
#include "RenderedUsualCar.h"
#include "RenderedView.h"
#include "scenery/nodes/AircraftModel.h"

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
    UsualCar car;
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
    scene.root->addChild(scenery::makeLightAircraft({trimRed, 0.22F, 0.50F, 1.0F}));
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
        UsualCar car;
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

TEST(ViewGolden, SmallChangesDoNotMatch)
{
    if (rendered::writesGoldens()) GTEST_SKIP() << "goldens are being written";
    const auto backend = osgOffscreen::defaultBackend();
    EXPECT_FALSE(rendered::matchesGolden(*carPicture(backend, 6.0), "view-car", rendererOf(backend)));
    EXPECT_FALSE(
        rendered::matchesGolden(*aircraftPicture(backend, 0.3F), "view-aircraft", rendererOf(backend)));
}
