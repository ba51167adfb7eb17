// SPDX-License-Identifier: Apache-2.0
// Values out of range are refused, by name, and change nothing.
#include <memory>

#include <gtest/gtest.h>

#include <osgTerrainROAM/RoamTerrain>

#include "RefusedSettings.h"
#include "SyntheticField.h"

namespace
{

using osgTerrainROAM::ImageryLayer;
using osgTerrainROAM::RoamDrawable;
using osgTerrainROAM::RoamDrawableSettings;
using osgTerrainROAM::RoamTerrain;
using osgTerrainROAM::TerrainMaterial;
using testsupport::expectRefused;
using testsupport::kInfinity;
using testsupport::kNaN;

TEST(RoamTerrainEditor, IsHandedOutWhileTheMethodFollowsEdits)
{
    using namespace osgTerrainROAM::core;
    const osg::ref_ptr<RoamTerrain> terrain = new RoamTerrain(
        std::make_shared<RoamTile>(PlacedTile(testsupport::hills(65, 65), Placement::planar)), nullptr);
    for (const MethodTraits& traits : kMethods)
    {
        RoamDrawableSettings settings;
        settings.method = traits.method;
        ASSERT_TRUE(terrain->setSettings(settings)) << traits.name;
        EXPECT_EQ(terrain->editor() != nullptr, traits.followsEdits) << traits.name;
    }
    ASSERT_TRUE(terrain->setSettings({}));
    EXPECT_TRUE(terrain->editor());
}

TEST(RoamDrawableSettings, RefusesWhatIsNoNumberOrOutOfRange)
{
    using S = RoamDrawableSettings;
    const S good{.maxAdaptTimeUs = kInfinity, .skirtM = 0.0, .patchExponent = 10, .defaultErrorM = 0.0};
    expectRefused(good, &S::errorTolerancePx, "RoamDrawable.errorTolerancePx", {kNaN, kInfinity, 0.0, -1.0});
    expectRefused(good, &S::maxTriangles, "RoamDrawable.maxTriangles", {0u, 1u});
    expectRefused(good, &S::maxAdaptTimeUs, "RoamDrawable.maxAdaptTimeUs", {kNaN, 0.0, -1.0});
    expectRefused<S, std::optional<double>>(good, &S::skirtM, "RoamDrawable.skirtM", {kNaN, kInfinity, -1.0});
    expectRefused(good, &S::patchExponent, "RoamDrawable.patchExponent", {3, -2, 12});
    expectRefused(good, &S::nearestM, "RoamDrawable.nearestM", {kNaN, kInfinity, 0.0, -1.0});
    expectRefused<S, std::optional<double>>(good, &S::defaultErrorM, "RoamDrawable.defaultErrorM",
                                            {kNaN, kInfinity, -1.0});
    expectRefused<S, std::optional<double>>(good, &S::viewMarginDeg, "RoamDrawable.viewMarginDeg",
                                            {kNaN, kInfinity, -1.0, 91.0});
}

TEST(RoamDrawableSettings, ARefusedValueChangesNothing)
{
    const osg::ref_ptr<RoamTerrain> terrain =
        new RoamTerrain(testsupport::planarTile(testsupport::hills(33, 33)), nullptr);
    RoamDrawable& drawable = *terrain->drawable();
    ASSERT_TRUE(drawable.setErrorTolerancePx(3.0));
    ASSERT_TRUE(drawable.setPatchExponent(2));
    const RoamDrawableSettings before = drawable.settings();
    EXPECT_FALSE(drawable.setErrorTolerancePx(kNaN));
    EXPECT_FALSE(drawable.setMaxTriangles(0));
    EXPECT_FALSE(drawable.setMaxAdaptTimeUs(kNaN));
    EXPECT_FALSE(drawable.setSkirtM(kNaN));
    EXPECT_FALSE(drawable.setPatchExponent(3));
    EXPECT_FALSE(drawable.setNearestM(0.0));
    EXPECT_FALSE(drawable.setDefaultErrorM(-1.0));
    RoamDrawableSettings oneWrong;
    oneWrong.nearestM = kNaN;
    EXPECT_FALSE(terrain->setSettings(oneWrong));
    EXPECT_EQ(terrain->settings(), before);
}

TEST(RoamDrawableSettings, ACopyHasThemToo)
{
    const osg::ref_ptr<RoamDrawable> drawable = new RoamDrawable;
    const RoamDrawableSettings settings{.errorTolerancePx = 2.5,
                                        .maxTriangles = 500,
                                        .maxAdaptTimeUs = 100.0,
                                        .adaptClock = viewlod::Budget::Clock::modelled,
                                        .morphing = true,
                                        .skirtM = 4.0,
                                        .patchExponent = 4,
                                        .nearestM = 0.5,
                                        .defaultErrorM = 2.0,
                                        .viewMarginDeg = 5.0};
    ASSERT_TRUE(drawable->setSettings(settings));
    const osg::ref_ptr<RoamDrawable> copy = new RoamDrawable(*drawable);
    EXPECT_EQ(copy->settings(), settings);
}

TEST(TerrainMaterialSettings, RefusesSeasonsOutsideAYearAndImageryThatCannotBeLaid)
{
    const auto tile = testsupport::planarTile(testsupport::hills(33, 33));
    const osg::ref_ptr<TerrainMaterial> material = new TerrainMaterial(tile->tile, {});
    ASSERT_TRUE(material->setSeason(0.25));
    for (const double wrong : {kNaN, -0.1, 1.1})
        EXPECT_FALSE(material->setSeason(wrong)) << wrong;
    EXPECT_EQ(material->season(), 0.25);

    ImageryLayer good{new osg::Image, glm::dvec2(0.0), glm::dvec2(32.0), 1.0};
    good.image->allocateImage(4, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    ASSERT_TRUE(material->setImagery({good}));
    EXPECT_FALSE(material->setImagery(std::vector(5, good)));
    const auto refused = [&](auto spoil)
    {
        ImageryLayer layer = good;
        spoil(layer);
        return !material->setImagery({layer, good});
    };
    EXPECT_TRUE(refused([](ImageryLayer& layer) { layer.image = nullptr; }));
    EXPECT_TRUE(refused([](ImageryLayer& layer) { layer.lastGrid = layer.firstGrid; }));
    EXPECT_TRUE(refused([](ImageryLayer& layer) { layer.texelM = 0.0; }));
    EXPECT_EQ(material->imageryLayers(), 1u);
}

} // namespace
