// SPDX-License-Identifier: Apache-2.0
// Values out of range are refused, by name, and change nothing.
#include <cmath>

#include <gtest/gtest.h>

#include <osgSky/Atmosphere>

#include "RefusedSettings.h"

namespace
{

using osgSky::Atmosphere;
using osgSky::AtmosphereSettings;
using testsupport::expectRefused;
using testsupport::kInfinity;
using testsupport::kNaN;

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

} // namespace
