// SPDX-License-Identifier: Apache-2.0
// The ground before a car by night, with its head lamps lit and dark.
#include "scenery/nodes/HeadLampBeam.h"

#include <gtest/gtest.h>

#include "InteriorStudio.h"

namespace
{

using scenery::models::EntityLamp;

constexpr int kPx = 80;

osgSky::AtmosphereSettings nightAir()
{
    osgSky::AtmosphereSettings air;
    air.sunDirectionWorld = osgSky::sunDirectionFromAngles(0.0, -30.0);
    return air;
}

/// Level ground, 80 m by 80 about the origin, seen from above; x is to the right.
class NightGround
{
public:
    NightGround() : _scene(nightAir()), _beam(*_scene.root->getOrCreateStateSet())
    {
        if (auto made =
                osgOffscreen::OffscreenViewer::create({.widthPx = kPx, .heightPx = kPx, .samples = 1}))
            _viewer = std::move(*made);
        if (!_viewer) return;
        _viewer->viewer().setSceneData(_scene.root);
        _viewer->camera().setViewMatrixAsLookAt({0.0, 0.0, 50.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
        _viewer->camera().setProjectionMatrixAsOrtho(-40.0, 40.0, -40.0, 40.0, 1.0, 100.0);
    }

    bool isThere() const { return _viewer != nullptr; }

    osg::ref_ptr<osg::Image> picture(bool isLit)
    {
        EntityLamp left, right;
        left.middle = {2.0, 0.6, 0.65};
        right.middle = {2.0, -0.6, 0.65};
        _beam.show({}, {left, right}, isLit);
        return _viewer->picture();
    }

private:
    rendered::ViewScene _scene;
    scenery::HeadLampBeam _beam;
    std::unique_ptr<osgOffscreen::OffscreenViewer> _viewer;
};

/// Of a place of the ground, 0 … 1. Units: metres.
double greenAt(const osg::Image& image, double x, double y)
{
    return image.getColor(static_cast<unsigned>(40.0 + x), static_cast<unsigned>(40.0 + y)).g();
}

TEST(HeadLampBeam, LightsTheGroundBeforeTheCarAlone)
{
    NightGround ground;
    ASSERT_TRUE(ground.isThere());
    const auto dark = ground.picture(false), lit = ground.picture(true), darkAgain = ground.picture(false);
    EXPECT_GT(greenAt(*lit, 12.0, 0.0), greenAt(*dark, 12.0, 0.0) + 0.2);
    EXPECT_GT(greenAt(*lit, 35.0, 0.0), greenAt(*dark, 35.0, 0.0) + 0.05) << "it ends too soon";
    EXPECT_GT(greenAt(*lit, 12.0, 0.0), greenAt(*lit, 12.0, 12.0)) << "it does not end at the sides";
    EXPECT_LT(greenAt(*lit, 4.0, 0.0), greenAt(*lit, 10.0, 0.0)) << "a white pool before the bumper";
    EXPECT_EQ(greenAt(*lit, -12.0, 0.0), greenAt(*dark, -12.0, 0.0)) << "it lights what is behind";
    EXPECT_EQ(greenAt(*darkAgain, 12.0, 0.0), greenAt(*dark, 12.0, 0.0)) << "it cannot be switched off";
}

} // namespace
