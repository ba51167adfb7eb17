// SPDX-License-Identifier: Apache-2.0
// Colours of the ground in the picture against what such ground reflects. Light of known strength falls on
// each kind of ground, and from the mean of its pixels follows what share of it came back. Sources of the
// reflectances, which are those of visible light, where plants are darker than in the near infrared that
// other tables include: Bowker et al., Spectral reflectances of natural targets for use in remote sensing
// studies, NASA RP-1139 (1985): grass, conifers, soils, rocks; Warren, Optical properties of snow (1982);
// Pomerantz, Akbari and Harvey, Cooler reflective pavements (2000): asphalt, 0.04 when new and 0.12 in the
// mean after five years.
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "FeatureScene.h"
#include "measurement/light/view/ShownLight.h"

namespace
{

using namespace osgTerrainROAM;
using namespace featurescene;
using core::GroundKind;

/// What is known of a kind of ground: its reflectance as the eye weighs it, and its colour.
struct Known
{
    std::string name;
    double least, most;
    enum
    {
        grey,
        green,
        brown,
        bluish
    } colour;
};

double luminance(const osg::Vec3d& c)
{
    return 0.2126 * c.x() + 0.7152 * c.y() + 0.0722 * c.z();
}

/// Undoes displayColour() as its description tells it, for one channel of a pixel, 0…1.
double lightOf(double shown, double exposure)
{
    return measurement::exposedOf(shown) / exposure;
}

/// What a description of the light says that white level ground sends back.
osg::Vec3d levelLight(const RoamTerrain& terrain)
{
    const osgSky::AtmosphereLight& light = terrain.atmosphere()->light();
    osg::Vec3d sun = terrain.atmosphere()->settings().sunDirectionWorld;
    sun.normalize();
    return osg::Vec3d(light.sun) * sun.z() + osg::Vec3d(light.sky);
}

/// Mean reflectance of what is seen from 30 m straight above the middle of the plain.
osg::Vec3d reflectance(const osg::ref_ptr<RoamTerrain>& terrain)
{
    Camera camera(terrain);
    const auto picture = camera.picture({20000.0, 20000.0, 30.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0});
    const double exposure = osgSky::exposureOf(0.30F * static_cast<float>(levelLight(*terrain).x()) +
                                               0.59F * static_cast<float>(levelLight(*terrain).y()) +
                                               0.11F * static_cast<float>(levelLight(*terrain).z()));
    osg::Vec3d sum;
    for (int y = 0; y < kHeightPx; ++y)
        for (int x = 0; x < kWidthPx; ++x)
        {
            const unsigned char* p = picture->data(x, y);
            for (int i = 0; i < 3; ++i)
                sum[i] += lightOf(p[i] / 255.0, exposure);
        }
    sum /= static_cast<double>(kWidthPx) * kHeightPx;
    const osg::Vec3d level = levelLight(*terrain);
    return {sum.x() / level.x(), sum.y() / level.y(), sum.z() / level.z()};
}

osg::ref_ptr<RoamTerrain> groundOf(GroundKind kind)
{
    const auto terrain = plain({});
    core::CoverMap map;
    map.width = map.height = 257;
    map.kinds.assign(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height), kind);
    terrain->material()->setCover(map);
    return terrain;
}

/// Under asphalt 60 m wide.
osg::ref_ptr<RoamTerrain> asphalt()
{
    return plain({line(core::FeatureKind::runway, 60.0, {20000.0, 19920.0}, {20000.0, 20080.0})});
}

/// Imagery of one grey, which the detail of the ground changes by nothing in the mean.
osg::ref_ptr<RoamTerrain> greyCard(double reflectance)
{
    const auto terrain = plain({});
    ImageryLayer layer{new osg::Image, glm::dvec2(0.0), glm::dvec2(256.0)};
    layer.image->allocateImage(4, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    const auto level = static_cast<unsigned char>(std::lround(255.0 * std::sqrt(reflectance)));
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x)
            for (int i = 0; i < 4; ++i)
                layer.image->data(x, y)[i] = i < 3 ? level : 255;
    layer.texelM = 64000.0 / 3.0;
    EXPECT_TRUE(terrain->material()->setImagery({layer}));
    return terrain;
}

double meanLevel(const osg::ref_ptr<RoamTerrain>& terrain)
{
    Camera camera(terrain);
    const auto picture = camera.picture({20000.0, 20000.0, 30.0}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0});
    double sum = 0.0;
    for (int y = 0; y < kHeightPx; ++y)
        for (int x = 0; x < kWidthPx; ++x)
            sum += level(*picture, x, y);
    return sum / (kWidthPx * kHeightPx);
}

void exposeMore(const osg::ref_ptr<RoamTerrain>& terrain, float factor)
{
    osg::Uniform* const exposure = terrain->atmosphere()->stateSet()->getUniform("atmosphereExposure");
    float value = 0.0F;
    ASSERT_TRUE(exposure->get(value));
    exposure->set(factor * value);
}

bool hasColour(const osg::Vec3d& seen, int colour)
{
    const double red = seen.x() / seen.y(), blue = seen.z() / seen.y();
    switch (colour)
    {
    case Known::green:
        return red < 0.85 && blue < 0.7;
    case Known::brown:
        return red > 1.05 && blue < 0.9;
    case Known::grey:
        return std::abs(red - 1.0) < 0.12 && std::abs(blue - 1.0) < 0.15;
    default:
        return red <= 1.01 && blue >= 0.99;
    }
}

void expectKnown(const Known& known, const osg::Vec3d& seen)
{
    SCOPED_TRACE(known.name + " " + std::to_string(seen.x()) + " " + std::to_string(seen.y()) + " " +
                 std::to_string(seen.z()));
    testing::Test::RecordProperty(known.name, std::to_string(luminance(seen)) + ": " +
                                                  std::to_string(seen.x()) + ", " + std::to_string(seen.y()) +
                                                  ", " + std::to_string(seen.z()));
    EXPECT_GT(luminance(seen), known.least);
    EXPECT_LT(luminance(seen), known.most);
    EXPECT_TRUE(hasColour(seen, known.colour));
}

} // namespace

TEST(SunlitGround, GroundReflectsWhatSuchGroundReflects)
{
    expectKnown({"meadow", 0.06, 0.14, Known::green}, reflectance(groundOf(GroundKind::meadow)));
    expectKnown({"forest", 0.025, 0.08, Known::green}, reflectance(groundOf(GroundKind::forest)));
    expectKnown({"rock", 0.12, 0.35, Known::grey}, reflectance(groundOf(GroundKind::rock)));
    expectKnown({"soil", 0.08, 0.25, Known::brown}, reflectance(groundOf(GroundKind::soil)));
    expectKnown({"asphalt", 0.04, 0.16, Known::grey}, reflectance(asphalt()));
    expectKnown({"snow", 0.70, 0.95, Known::bluish}, reflectance(groundOf(GroundKind::snow)));
}

TEST(SunlitGround, AMediumSceneInFullSunIsAMediumGrey)
{
    // 12.4 % is what an outdoor scene reflects in the mean (Dickerson and Zawadzki, 2008), 118 of 255 is
    // sRGB's grey of 18 %, for which meters aim (ISO 2720).
    EXPECT_NEAR(meanLevel(greyCard(0.124)), 118.0, 2.0);
    const auto brighter = greyCard(0.124);
    exposeMore(brighter, 1.1F);
    EXPECT_GT(meanLevel(brighter), 121.5) << "a tenth more is seen";
}

TEST(SunlitGround, ATenthMoreOfExposureIsSeenInAReflectance)
{
    EXPECT_NEAR(luminance(reflectance(greyCard(0.3))), 0.3, 0.012);
    const auto brighter = greyCard(0.3);
    exposeMore(brighter, 1.1F);
    EXPECT_GT(luminance(reflectance(brighter)), 0.318);
}

TEST(SunlitGround, AShadowIsBlueAndASlopeInTheSunIsWarm)
{
    // The same light that all shaders use: on level ground at noon it is white, without the sun blue, without
    // the sky warm.
    const auto terrain = plain({});
    const osgSky::AtmosphereLight& light = terrain->atmosphere()->light();
    const osg::Vec3d level = levelLight(*terrain);
    EXPECT_NEAR(level.x() / level.y(), 1.0, 0.05);
    EXPECT_NEAR(level.z() / level.y(), 1.0, 0.05);
    EXPECT_GT(light.sky.z(), 1.5F * light.sky.x());
    EXPECT_GT(light.sun.x(), 1.15F * light.sun.z());
}
