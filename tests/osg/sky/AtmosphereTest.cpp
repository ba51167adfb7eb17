// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include <osg/Math>
#include <osgSky/Atmosphere>

namespace
{

using namespace osgSky;

AtmosphereSettings withSun(double elevationDeg)
{
    AtmosphereSettings settings;
    settings.sunDirectionWorld = sunDirectionFromAngles(180.0, elevationDeg);
    return settings;
}

float brightness(const osg::Vec3f& c)
{
    return (c.x() + c.y() + c.z()) / 3.0f;
}

} // namespace

TEST(Atmosphere, ContrastOverTheVisibilityIsFivePercent)
{
    for (const double visibilityM : {200.0, 1500.0, 20000.0, 80000.0})
    {
        AtmosphereSettings settings;
        settings.visibilityM = visibilityM;
        const AtmosphereLight light = atmosphereLight(settings);
        EXPECT_NEAR(std::exp(-light.extinction.y() * visibilityM), 0.05, 1e-3);
    }
}

TEST(Atmosphere, BlueIsScatteredMoreInHazeAndNotInFog)
{
    const AtmosphereLight haze = atmosphereLight({});
    EXPECT_GT(haze.extinction.z(), 1.1f * haze.extinction.x());
    AtmosphereSettings fog;
    fog.visibilityM = 300.0;
    const AtmosphereLight dense = atmosphereLight(fog);
    EXPECT_NEAR(dense.extinction.z(), dense.extinction.x(), 1e-6f * dense.extinction.x());
}

TEST(Atmosphere, FogHidesTheSunAndTheSkyIsTheFogs)
{
    AtmosphereSettings fog;
    fog.visibilityM = 300.0;
    fog.fogColour = osg::Vec3f(0.5f, 0.4f, 0.3f);
    const AtmosphereLight light = atmosphereLight(fog);
    EXPECT_LT(brightness(light.sun), 0.01f);
    EXPECT_NEAR((light.zenith - *fog.fogColour).length(), 0.0f, 0.01f);
    EXPECT_NEAR((light.horizon - *fog.fogColour).length(), 0.0f, 0.01f);
}

TEST(Atmosphere, TheSunsHeightDecidesTheColours)
{
    const AtmosphereLight noon = atmosphereLight(withSun(60));
    const AtmosphereLight evening = atmosphereLight(withSun(4));
    const AtmosphereLight night = atmosphereLight(withSun(-20));
    EXPECT_GT(noon.zenith.z(), 2.0f * noon.zenith.x()) << "blue by day";
    EXPECT_GT(evening.sun.x(), 1.5f * evening.sun.z()) << "warm in the evening";
    EXPECT_EQ(brightness(night.sun), 0.0f);
    EXPECT_LT(brightness(night.sky), 0.05f * brightness(noon.sky));
}

TEST(Atmosphere, TheSunIsAsStrongBesideTheSkyAsItIsMeasured)
{
    // Clear skies: the sky gives a sixth to a tenth of the light of a high sun, as much as the sun at some 10
    // degrees.
    const auto ratio = [](double elevationDeg)
    {
        const AtmosphereLight light = atmosphereLight(withSun(elevationDeg));
        return light.sun.y() * std::sin(osg::DegreesToRadians(elevationDeg)) / light.sky.y();
    };
    EXPECT_GT(ratio(60.0), 4.5);
    EXPECT_LT(ratio(60.0), 10.0);
    EXPECT_GT(ratio(20.0), 1.0);
    EXPECT_LT(ratio(5.0), 0.6);
    const AtmosphereLight evening = atmosphereLight(withSun(8.0));
    EXPECT_GT(evening.sun.x(), 2.0f * evening.sun.z()) << "warm";
    EXPECT_GT(evening.sky.z(), 1.2f * evening.sky.x()) << "shadows are blue";
}

TEST(Atmosphere, TheExposureFollowsTheLightByAPart)
{
    const AtmosphereLight noon = atmosphereLight(withSun(60)), evening = atmosphereLight(withSun(8));
    const auto card = [](const AtmosphereLight& light, double elevationDeg)
    {
        const float level =
            light.sun.y() * static_cast<float>(std::sin(osg::DegreesToRadians(elevationDeg))) + light.sky.y();
        return displayColour(osg::Vec3f(0.124f, 0.124f, 0.124f) * level, light.exposure).y() * 255.0f;
    };
    EXPECT_GT(evening.exposure, 1.3f * noon.exposure);
    EXPECT_LT(card(evening, 8.0), 0.8f * card(noon, 60.0)) << "an evening stays darker";
    EXPECT_NEAR(card(noon, 60.0), 118.0f, 3.0f);
    EXPECT_EQ(exposureOf(1e-9f), exposureOf(0.0f)) << "and the night has an end";
    EXPECT_EQ(exposureOf(100.0f), exposureOf(2.0f)) << "as has the day";
}

TEST(Atmosphere, DuskIsAsDarkAsInNature)
{
    // Bond and Henderson 1963, in lux; 88 000 at 60 degrees. A full moon: Brown 1952.
    const auto level = [](double elevationDeg, double moonlight)
    {
        AtmosphereSettings settings = withSun(elevationDeg);
        settings.moonlight = moonlight;
        const AtmosphereLight light = atmosphereLight(settings);
        const double sine = std::max(std::sin(osg::DegreesToRadians(elevationDeg)), 0.0);
        return light.sun.y() * sine + light.sky.y();
    };
    const double noon = level(60.0, 0.0);
    for (const auto& [elevationDeg, lux] :
         {std::pair{5.0, 6000.0}, {0.0, 700.0}, {-3.0, 60.0}, {-6.0, 3.4}, {-12.0, 8.3e-3}})
        EXPECT_NEAR(level(elevationDeg, 0.0) / noon * 88000.0 / lux, 1.0, 0.15) << elevationDeg;
    EXPECT_NEAR(level(-30.0, 1.0) / noon * 88000.0 / 0.108, 1.0, 0.15) << "a full moon";
}

TEST(Atmosphere, AnEyeUsedToTheDarkSeesLampsAndItsPictureStaysAsBright)
{
    EXPECT_EQ(atmosphereLight(withSun(15.0)).adaptation, 1.0f);
    EXPECT_LT(atmosphereLight(withSun(0.0)).lampShare, 0.005f) << "head lamps at sunset";
    EXPECT_NEAR(atmosphereLight(withSun(-6.0)).lampShare, 0.09f, 0.03f);
    EXPECT_EQ(atmosphereLight(withSun(-20.0)).lampShare, 1.0f);
    AtmosphereLight before = atmosphereLight(withSun(16.0));
    for (int tenths = 159; tenths > -180; --tenths)
    {
        const AtmosphereLight light = atmosphereLight(withSun(0.1 * tenths));
        EXPECT_GE(light.adaptation, 0.98f * before.adaptation) << 0.1 * tenths;
        EXPECT_LT(light.adaptation, 1.3f * before.adaptation) << 0.1 * tenths;
        EXPECT_LE(light.exposure / light.adaptation, 2.35f) << 0.1 * tenths;
        before = light;
    }
    const osg::ref_ptr<Atmosphere> air = new Atmosphere(withSun(-20.0));
    osg::Vec3f shown;
    air->stateSet()->getUniform("atmosphereSky")->get(shown);
    EXPECT_NEAR(shown.y(), air->light().sky.y() * air->light().adaptation, 1e-6f);
}

TEST(Atmosphere, LightChangesSteadilyWithTheSun)
{
    AtmosphereLight before = atmosphereLight(withSun(-20.0));
    for (int tenths = -199; tenths < 900; ++tenths)
    {
        const double elevation = 0.1 * tenths;
        const AtmosphereLight light = atmosphereLight(withSun(elevation));
        EXPECT_LT((light.horizon - before.horizon).length(), 0.02f) << elevation;
        EXPECT_LT((light.sun - before.sun).length(), 0.08f) << elevation;
        before = light;
    }
}

TEST(Atmosphere, ASunWithoutADirectionStandsOverhead)
{
    AtmosphereSettings settings;
    settings.sunDirectionWorld.set(0, 0, 0);
    const AtmosphereLight light = atmosphereLight(settings);
    EXPECT_EQ(light.sun, atmosphereLight(withSun(90.0)).sun);
}

TEST(Atmosphere, ApplyingChangesTheSameUniforms)
{
    const osg::ref_ptr<Atmosphere> air = new Atmosphere;
    osg::ref_ptr<osg::StateSet> shared = new osg::StateSet;
    air->addUniformsTo(*shared);
    AtmosphereSettings fog;
    fog.visibilityM = 100.0;
    ASSERT_TRUE(air->setSettings(fog));
    osg::Vec3f extinction;
    ASSERT_TRUE(shared->getUniform("atmosphereExtinction")->get(extinction));
    EXPECT_NEAR(std::exp(-extinction.y() * 100.0f), 0.05f, 1e-3f);
    EXPECT_EQ(air->stateSet()->getDataVariance(), osg::Object::DYNAMIC)
        << "frames being drawn must be waited for";
}

TEST(Atmosphere, AnglesAreClockwiseFromNorth)
{
    EXPECT_NEAR((sunDirectionFromAngles(90.0, 0.0) - osg::Vec3d(1, 0, 0)).length(), 0.0, 1e-12);
    EXPECT_NEAR((sunDirectionFromAngles(0.0, 0.0) - osg::Vec3d(0, 1, 0)).length(), 0.0, 1e-12);
    EXPECT_NEAR((sunDirectionFromAngles(123.0, 90.0) - osg::Vec3d(0, 0, 1)).length(), 0.0, 1e-12);
}
