// SPDX-License-Identifier: Apache-2.0
// Values out of range are refused, by name, and change nothing.
#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include <osgTerrainROAM/RoamTerrain>

#include "SyntheticField.h"

namespace
{

using osgTerrainROAM::Atmosphere;
using osgTerrainROAM::AtmosphereSettings;
using osgTerrainROAM::ImageryLayer;
using osgTerrainROAM::RoamDrawable;
using osgTerrainROAM::RoamDrawableSettings;
using osgTerrainROAM::RoamTerrain;
using osgTerrainROAM::TerrainMaterial;

const double kNaN = std::nan("");
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Each wrong value of one field has to be refused at "Owner.field".
template<class Settings, class Value>
void expectRefused(const Settings& good, Value Settings::*field, const std::string& place,
                   std::initializer_list<Value> wrong)
{
    EXPECT_TRUE(checkSettings(good)) << place;
    for (const Value& value : wrong)
    {
        Settings settings = good;
        settings.*field = value;
        const auto checked = checkSettings(settings);
        ASSERT_FALSE(checked) << place;
        EXPECT_EQ(checked.error().place, place);
        EXPECT_NE(checked.error().remedy.find("give "), std::string::npos);
    }
}

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
                                        .defaultErrorM = 2.0};
    ASSERT_TRUE(drawable->setSettings(settings));
    const osg::ref_ptr<RoamDrawable> copy = new RoamDrawable(*drawable);
    EXPECT_EQ(copy->settings(), settings);
}

TEST(AtmosphereSettings, RefusesWhatIsNoNumberOrOutOfRange)
{
    using S = AtmosphereSettings;
    const S good;
    expectRefused(good, &S::sunDirectionWorld, "Atmosphere.sunDirectionWorld",
                  {osg::Vec3d(), osg::Vec3d(kNaN, 0.0, 1.0), osg::Vec3d(0.0, kInfinity, 0.0)});
    expectRefused(good, &S::visibilityM, "Atmosphere.visibilityM", {kNaN, kInfinity, 0.0, -5.0});
    expectRefused(good, &S::hazeBaseM, "Atmosphere.hazeBaseM", {kNaN, kInfinity});
    expectRefused(good, &S::sunIntensity, "Atmosphere.sunIntensity", {kNaN, kInfinity, -1.0});
    expectRefused(good, &S::cloudCover, "Atmosphere.cloudCover", {kNaN, -0.1, 1.1});
    expectRefused(good, &S::moonlight, "Atmosphere.moonlight", {kNaN, -0.1, 1.1});
    expectRefused<S, std::optional<osg::Vec3f>>(
        good, &S::fogColour, "Atmosphere.fogColour",
        {osg::Vec3f(std::nanf(""), 0.0f, 0.0f), osg::Vec3f(0.0f, -1.0f, 2.0f)});
}

TEST(AtmosphereSettings, ARefusedValueChangesNothing)
{
    const osg::ref_ptr<Atmosphere> air = new Atmosphere;
    AtmosphereSettings foggy;
    foggy.visibilityM = 300.0;
    ASSERT_TRUE(air->setSettings(foggy));
    const osg::Vec3f extinction = air->light().extinction;
    EXPECT_FALSE(air->setSettings({.visibilityM = kNaN}));
    EXPECT_EQ(air->settings(), foggy);
    EXPECT_EQ(air->light().extinction, extinction);
    const osg::ref_ptr<Atmosphere> made = new Atmosphere({.visibilityM = kNaN});
    EXPECT_EQ(made->settings(), AtmosphereSettings()) << "a refused start leaves the default";
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
