// SPDX-License-Identifier: Apache-2.0
// The state of a traffic light is seen in its picture.
#include <gtest/gtest.h>

#include <osgSky/Atmosphere>

#include "RenderedPicture.h"
#include "scenery/nodes/RoadThingsNode.h"

namespace
{

using scenery::LightState;

/// A traffic light of id 7 at the origin, looking towards -x, and one that is not looked at.
scenery::roads::RoadThings
twoLights(scenery::models::RoadModel::Arrow arrow = scenery::models::RoadModel::Arrow::none)
{
    scenery::models::RoadModel light;
    light.kind = scenery::models::RoadModel::Kind::trafficLight;
    light.raisedM = 2.0;
    light.arrow = arrow;
    scenery::roads::RoadThings things;
    things.models = {light};
    scenery::roads::StandingThing thing;
    thing.signalId = "7";
    things.standing.push_back(thing);
    thing.signalId = "8";
    thing.position.y = 100.0;
    things.standing.push_back(thing);
    return things;
}

/// How many pixels shine red, amber and green, and how many green ones in the left half.
struct Shining
{
    int red = 0, amber = 0, green = 0, greenOnLeft = 0;
    bool operator==(const Shining&) const = default;
};

Shining countIn(const osg::Image& picture)
{
    Shining count;
    for (int row = 0; row < picture.t(); ++row)
        for (int column = 0; column < picture.s(); ++column)
        {
            const osg::Vec4 colour = picture.getColor(column, row);
            if (colour.r() > 0.8F && colour.g() < 0.4F) ++count.red;
            if (colour.r() > 0.8F && colour.g() > 0.5F && colour.b() < 0.45F) ++count.amber;
            if (colour.g() > 0.75F && colour.r() < 0.5F)
            {
                ++count.green;
                count.greenOnLeft += column < picture.s() / 2 ? 1 : 0;
            }
        }
    return count;
}

/// One node and one viewer for all states: contexts take most of the time.
class RoadLights : public testing::Test
{
protected:
    void SetUp() override { show(scenery::models::RoadModel::Arrow::none, 3.0); }

    void show(scenery::models::RoadModel::Arrow arrow, double distanceM = 1.4)
    {
        auto made = scenery::RoadThingsNode::create(twoLights(arrow));
        ASSERT_TRUE(made) << made.error().message();
        _things = std::move(*made);
        const osg::ref_ptr<osgSky::Atmosphere> air = new osgSky::Atmosphere;
        const osg::ref_ptr<osg::Group> root = new osg::Group;
        root->setStateSet(air->stateSet());
        root->addChild(_things->node());
        osgOffscreen::OffscreenSettings settings;
        settings.widthPx = settings.heightPx = 96;
        _viewer = rendered::viewerOf(root, settings);
        ASSERT_TRUE(_viewer);
        _viewer->camera().setClearColor({0.3F, 0.3F, 0.3F, 1.0F});
        _viewer->camera().setViewMatrixAsLookAt({-distanceM, 0.0, 2.42}, {0.0, 0.0, 2.42}, {0.0, 0.0, 1.0});
    }

    Shining shown() { return countIn(*_viewer->picture()); }

    std::unique_ptr<scenery::RoadThingsNode> _things;
    std::unique_ptr<osgOffscreen::OffscreenViewer> _viewer;
};

TEST_F(RoadLights, ShowTheirState)
{
    const Shining stop = shown();
    EXPECT_GT(stop.red, 50);
    EXPECT_EQ(stop.amber + stop.green, 0);

    ASSERT_TRUE(_things->setState("7", LightState::attention));
    const Shining attention = shown();
    EXPECT_EQ(attention.red, stop.red);
    EXPECT_GT(attention.amber, 50);

    ASSERT_TRUE(_things->setState("7", "green"));
    const Shining go = shown();
    EXPECT_GT(go.green, 50);
    EXPECT_EQ(go.red + go.amber, 0);

    ASSERT_TRUE(_things->setState("7", "off;on;off"));
    const Shining second = shown();
    EXPECT_GT(second.amber, 50);
    EXPECT_EQ(second.red + second.green, 0);
    EXPECT_FALSE(_things->setState("7", "off;bright;off"));

    ASSERT_TRUE(_things->setState("7", LightState::off));
    EXPECT_EQ(shown(), Shining());
}

TEST_F(RoadLights, KeepTheirStateWhenAnotherIsSet)
{
    const Shining before = shown();
    EXPECT_TRUE(_things->setState("8", LightState::go));
    EXPECT_FALSE(_things->setState("9", LightState::go)); // there is none of that id
    EXPECT_FALSE(_things->setState("7", "purple"));
    EXPECT_EQ(shown(), before);
}

/// A green lamp is an arrow, a red one has a dark arrow on it.
TEST_F(RoadLights, PointWhereTheirArrowsDo)
{
    show(scenery::models::RoadModel::Arrow::none);
    const Shining disc = shown();
    ASSERT_TRUE(_things->setState("7", LightState::go));
    const Shining round = shown();
    EXPECT_NEAR(round.greenOnLeft, 0.5 * round.green, 0.1 * round.green);

    show(scenery::models::RoadModel::Arrow::left);
    const Shining stop = shown();
    EXPECT_LT(stop.red, 0.8 * disc.red);
    EXPECT_GT(stop.red, 0.4 * disc.red);
    ASSERT_TRUE(_things->setState("7", LightState::go));
    const Shining left = shown();
    EXPECT_LT(left.green, 0.6 * round.green);
    EXPECT_GT(left.greenOnLeft, 0.6 * left.green);

    show(scenery::models::RoadModel::Arrow::right);
    ASSERT_TRUE(_things->setState("7", LightState::go));
    EXPECT_LT(shown().greenOnLeft, 0.4 * left.green);
}

} // namespace
