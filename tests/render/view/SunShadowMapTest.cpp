// SPDX-License-Identifier: Apache-2.0
// Shadow maps in pictures: the shadow of a post lies where the sun's rays put it, from any eye and whichever
// way one looks.
#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <osg/Texture2D>
#include <osgSky/SunShadows>

#include "RenderedView.h"

namespace
{

constexpr int kWidthPx = 480, kHeightPx = 360;
constexpr double kPostM = 3.0, kHalfM = 0.2, kPostAtM = 4.0; ///< a post of 3 m, 0.4 m wide, 4 m east

osg::ref_ptr<osg::Geode> post()
{
    scenery::ModelMesh mesh;
    mesh.addBox({kPostAtM - kHalfM, -kHalfM, 0.0}, {kPostAtM + kHalfM, kHalfM, kPostM},
                {0.5F, 0.5F, 0.5F, 1.0F});
    osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(mesh.geometry());
    scenery::setObjectShading(*geode, scenery::Finish::matt);
    return geode;
}

/// A card of leaves, 2 m wide and 3 m high, 4 m east; its southern half is cut out, if `hasGap`.
osg::ref_ptr<osg::Geode> leaves(bool hasGap)
{
    const osg::ref_ptr<osg::Geode> geode = new osg::Geode;
    geode->addDrawable(
        osg::createTexturedQuadGeometry({kPostAtM, -1.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, kPostM}));
    scenery::setObjectShading(*geode, scenery::Finish::foliage);
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    std::fill_n(image->data(), 8, 255);
    if (hasGap) image->data()[3] = 0;
    const osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    geode->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
    return geode;
}

/// What casts shadows, and how.
struct Casting
{
    bool hasShadows = true;
    osgSky::SunShadowSettings maps{};
    unsigned int mask = ~0U; ///< of the caster's node
    osg::ref_ptr<osg::Geode> caster = post();
};

/// A picture of the post on a plain with the sun in the east, and where places on the plain are in it.
class Picture
{
public:
    Picture(double sunDeg, const glm::dvec3& eye, const glm::dvec3& at, const Casting& casting = {})
    {
        osgSky::AtmosphereSettings air;
        air.sunDirectionWorld = osgSky::sunDirectionFromAngles(90.0, sunDeg);
        const rendered::ViewScene scene(air);
        const osg::ref_ptr<osgSky::SunShadows> sunlit =
            new osgSky::SunShadows(scene.atmosphere, casting.maps);
        sunlit->setShown(casting.hasShadows);
        const osg::ref_ptr<osg::Node> ground = scene.root->getChild(1);
        scene.root->removeChild(ground);
        sunlit->addChild(ground);
        casting.caster->setNodeMask(casting.mask);
        sunlit->addChild(casting.caster);
        scene.root->addChild(sunlit);
        osgOffscreen::OffscreenSettings settings;
        settings.backend = osgOffscreen::defaultBackend();
        settings.widthPx = kWidthPx;
        settings.heightPx = kHeightPx;
        settings.samples = 1;
        const scenery::Pose pose = scenery::poseLookingAt(eye, at);
        _clipFromWorld =
            glm::perspective(glm::radians(40.0), static_cast<double>(kWidthPx) / kHeightPx, 0.5, 2e5) *
            scenery::viewFromWorld(pose);
        _image = rendered::pictureFrom(scene.root, pose, settings);
    }

    /// The brightness of a place on the plain, 0…255.
    int at(double x, double y) const
    {
        const glm::dvec4 clip = _clipFromWorld * glm::dvec4(x, y, 0.0, 1.0);
        const auto column = static_cast<unsigned>((0.5 + 0.5 * clip.x / clip.w) * kWidthPx);
        const auto row = static_cast<unsigned>((0.5 + 0.5 * clip.y / clip.w) * kHeightPx);
        return _image->data(column, row)[1];
    }

    bool isDark(double x, double y) const { return at(x, y) < 0.8 * at(2.0, 1.5); }

    /// The western end of the shadow, metres east; absent without one.
    std::optional<double> shadowEnd() const
    {
        for (double x = -2.0; x < 3.0; x += 0.005)
            if (isDark(x, 0.0)) return x;
        return std::nullopt;
    }

    /// Its width at 3 m east.
    double shadowWidth() const
    {
        double width = 0.0;
        for (double y = -1.0; y < 1.0; y += 0.005)
            width += isDark(3.0, y) ? 0.005 : 0.0;
        return width;
    }

private:
    glm::dmat4 _clipFromWorld{1.0};
    osg::ref_ptr<osg::Image> _image;
};

const glm::dvec3 kEye(0.5, -6.0, 9.0), kAt(1.5, 0.0, 0.0);

double endOf(double sunDeg)
{
    return kPostAtM - kHalfM - kPostM / std::tan(glm::radians(sunDeg));
}

/// Two texels of the nearest map, and by how much a place is looked up off its surface at 11 m: 3 pixels
/// along the rays.
constexpr double kToleranceM = 0.15;

} // namespace

TEST(SunShadowMaps, AShadowLiesWhereTheRaysPutIt)
{
    for (const double sunDeg : {40.0, 50.0, 65.0})
    {
        const Picture picture(sunDeg, kEye, kAt);
        ASSERT_TRUE(picture.shadowEnd()) << sunDeg;
        EXPECT_NEAR(*picture.shadowEnd(), endOf(sunDeg), kToleranceM) << sunDeg;
        EXPECT_NEAR(picture.shadowWidth(), 2.0 * kHalfM, kToleranceM) << sunDeg;
    }
}

TEST(SunShadowMaps, ASunThatIsOffBySixDegreesIsSeen)
{
    EXPECT_GT(std::abs(*Picture(46.0, kEye, kAt).shadowEnd() - endOf(40.0)), kToleranceM) << "the mutation";
}

TEST(SunShadowMaps, TheShadowStaysWhenTheEyeMovesAndTurns)
{
    const double end = *Picture(50.0, kEye, kAt).shadowEnd();
    for (const glm::dvec3& by :
         {glm::dvec3(0.013, 0.0, 0.0), glm::dvec3(0.4, -0.3, 0.2), glm::dvec3(-3.0, 2.0, 1.0)})
        EXPECT_NEAR(*Picture(50.0, kEye + by, kAt + glm::dvec3(-0.5, 0.4, 0.0)).shadowEnd(), end, 0.05);
}

TEST(SunShadowMaps, WithoutSunOrSwitchedOffThereIsNone)
{
    EXPECT_FALSE(Picture(50.0, kEye, kAt, {.hasShadows = false}).shadowEnd());
    EXPECT_FALSE(Picture(-5.0, kEye, kAt).shadowEnd());
}

TEST(SunShadowMaps, LeavesCastTheShadowOfWhatIsSeenOfThem)
{
    const Picture cut(50.0, kEye, kAt, {.caster = leaves(true)});
    EXPECT_TRUE(cut.isDark(3.0, 0.5));
    EXPECT_FALSE(cut.isDark(3.0, -0.5)) << "the sun shines through the half that is cut out";
    EXPECT_TRUE(Picture(50.0, kEye, kAt, {.caster = leaves(false)}).isDark(3.0, -0.5)) << "the control";
}

TEST(SunShadowMaps, WhatMovesIsInTheNearestMapsAlone)
{
    using osgSky::SunShadows;
    osgSky::SunShadowSettings maps;
    maps.cellShare = 0.125;
    maps.movingMaps = 1;
    EXPECT_TRUE(Picture(50.0, kEye, kAt, {.maps = maps, .mask = osgSky::SunShadows::kMoves}).shadowEnd())
        << "near, it casts one";
    maps.movingMaps = 0;
    EXPECT_FALSE(Picture(50.0, kEye, kAt, {.maps = maps, .mask = osgSky::SunShadows::kMoves}).shadowEnd());
    EXPECT_TRUE(Picture(50.0, kEye, kAt, {.maps = maps}).shadowEnd()) << "what stands casts into all";
}
