// SPDX-License-Identifier: Apache-2.0
// Land cover, seasons and night, as the picture shows them.
#include <cmath>

#include <gtest/gtest.h>

#include <osgOffscreen/ImageComparison>

#include "FeatureScene.h"

namespace
{

using namespace osgTerrainROAM;
using namespace featurescene;
using core::GroundKind;

const osg::Vec3d kUp(0.0, 0.0, 1.0), kNorth(0.0, 1.0, 0.0);

/// West of 20 000 m one kind, east of it another, in texels of 50 m; 20 km wide and high is enough.
core::CoverMap halves(GroundKind west, GroundKind east)
{
    core::CoverMap map;
    map.width = map.height = 1281;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            map.kinds.push_back(x < 400 ? west : east);
    return map;
}

/// Mean colour of a part of a picture, 0…255.
osg::Vec3d meanOf(const osg::Image& picture, int firstX, int endX)
{
    osg::Vec3d sum;
    for (int y = 0; y < kHeightPx; ++y)
        for (int x = firstX; x < endX; ++x)
        {
            const unsigned char* p = picture.data(x, y);
            sum += osg::Vec3d(p[0], p[1], p[2]);
        }
    return sum / ((endX - firstX) * static_cast<double>(kHeightPx));
}

/// From 400 m straight down on the border of the halves.
osg::ref_ptr<osg::Image> fromAbove(const osg::ref_ptr<RoamTerrain>& terrain, double heightM = 400.0)
{
    Camera camera(terrain);
    return camera.picture({19975.0, 20000.0, heightM}, -kUp, kNorth);
}

/// How far, in pixels, the border between sand and forest strays from a straight line up the picture:
/// standard deviation.
double strayPx(const osg::Image& picture)
{
    double sum = 0.0, squares = 0.0;
    for (int y = 0; y < kHeightPx; ++y)
    {
        double sandy = 0.0;
        for (int x = 0; x < kWidthPx; ++x)
            sandy += level(picture, x, y) > 110.0 ? 1.0 : 0.0;
        sum += sandy / kHeightPx;
        squares += sandy * sandy / kHeightPx;
    }
    return std::sqrt(squares - sum * sum);
}

} // namespace

/// A settlement stands out from meadow by its gardens and yards.
TEST(CoverPaint, GardensAreDarkerThanMeadowAndYardsAreGrey)
{
    const auto terrain = plain({});
    terrain->material()->setCover(halves(GroundKind::meadow, GroundKind::garden));
    for (const double heightM : {400.0, 1500.0, 6000.0})
    {
        const auto picture = fromAbove(terrain, heightM);
        const osg::Vec3d meadow = meanOf(*picture, 0, 200), garden = meanOf(*picture, 280, kWidthPx);
        EXPECT_LT(garden.y(), 0.92 * meadow.y()) << heightM;
        EXPECT_GT(garden.y(), 0.6 * meadow.y()) << heightM;
    }
    terrain->material()->setCover(halves(GroundKind::meadow, GroundKind::yard));
    for (const double heightM : {400.0, 1500.0, 6000.0})
    {
        const auto picture = fromAbove(terrain, heightM);
        const osg::Vec3d meadow = meanOf(*picture, 0, 200), yard = meanOf(*picture, 280, kWidthPx);
        EXPECT_GT(yard.x(), 1.2 * meadow.x()) << heightM;
        EXPECT_LT(yard.y() - yard.x(), 0.5 * (meadow.y() - meadow.x())) << heightM;
    }
}

TEST(CoverPaint, EachSideOfABorderLooksLikeItsKind)
{
    const auto terrain = plain({});
    terrain->material()->setCover(halves(GroundKind::sand, GroundKind::forest));
    for (const double heightM : {400.0, 1500.0, 6000.0})
    {
        const auto picture = fromAbove(terrain, heightM);
        const osg::Vec3d sand = meanOf(*picture, 0, 200), forest = meanOf(*picture, 280, kWidthPx);
        EXPECT_GT(sand.x(), 150.0) << heightM;
        EXPECT_LT(forest.x(), 105.0) << heightM;
        EXPECT_GT(forest.y(), forest.x()) << heightM;
    }
}

TEST(CoverPaint, ABorderDoesNotFollowTheRastersGrid)
{
    const auto terrain = plain({});
    terrain->material()->setCover(halves(GroundKind::sand, GroundKind::forest));
    const double bent = strayPx(*fromAbove(terrain));
    terrain->material()->stateSet()->getUniform("coverBend")->set(osg::Vec4f());
    const double straight = strayPx(*fromAbove(terrain));
    EXPECT_GT(bent, 4.0);
    EXPECT_LT(straight, 0.5 * bent) << "without the bending it does";
}

TEST(CoverPaint, UnknownCoverLeavesTheGroundAsItWas)
{
    const auto bare = plain({});
    const auto covered = plain({});
    covered->material()->setCover(halves(GroundKind::unknown, GroundKind::unknown));
    EXPECT_TRUE(osgOffscreen::compareImages(*fromAbove(bare), *fromAbove(covered)).within(64, 1));
    covered->material()->setCover(halves(GroundKind::unknown, GroundKind::water));
    EXPECT_FALSE(osgOffscreen::compareImages(*fromAbove(bare), *fromAbove(covered)).within(64, 1));
}

TEST(SeasonPaint, GreenFadesUntilOctoberAndJanuary)
{
    const auto terrain = plain({});
    terrain->material()->setCover(halves(GroundKind::meadow, GroundKind::forest));
    const auto season = [&](double month)
    {
        EXPECT_TRUE(terrain->material()->setSeason((month - 0.5) / 12.0));
        return meanOf(*fromAbove(terrain), 0, 200);
    };
    const osg::Vec3d june = season(6), october = season(10), january = season(1);
    EXPECT_GT(june.y(), june.x() + 10.0) << "green";
    EXPECT_GT(october.x() - october.y(), june.x() - june.y() + 5.0) << "less so";
    EXPECT_LT(january.y() - january.x(), june.y() - june.x());
}

TEST(SeasonPaint, SnowComesDownToWhereItIsCold)
{
    // In January it lies 2300 m lower than in June; the plain is at 0 m.
    const auto snowy = [](double snowLineM)
    {
        const auto terrain = plain({});
        osg::Vec4f line;
        EXPECT_TRUE(terrain->material()->setSeason(0.5 / 12.0));
        terrain->material()->stateSet()->getUniform("seasonSnowLine")->get(line);
        line.x() = static_cast<float>(snowLineM);
        terrain->material()->stateSet()->getUniform("seasonSnowLine")->set(line);
        return meanOf(*fromAbove(terrain), 0, kWidthPx);
    };
    EXPECT_GT(snowy(1500.0).x(), 200.0);
    EXPECT_LT(snowy(4500.0).x(), 140.0);
}

TEST(NightPaint, ARunwayHasLightsOnlyAtNight)
{
    const auto terrain =
        plain({line(core::FeatureKind::runway, 45.0, {20000.0, 19000.0}, {20000.0, 21000.0})});
    const auto brightPixels = [&](double sunElevationDeg, double moonlight)
    {
        osgSky::AtmosphereSettings settings = terrain->atmosphere()->settings();
        settings.sunDirectionWorld = osgSky::sunDirectionFromAngles(200.0, sunElevationDeg);
        settings.moonlight = moonlight;
        EXPECT_TRUE(terrain->atmosphere()->setSettings(settings));
        Camera camera(terrain);
        const auto picture = camera.picture({20000.0, 18600.0, 80.0}, {0.0, 1.0, -0.3}, kUp);
        int bright = 0;
        double sum = 0.0;
        for (int y = 0; y < 225; ++y)
            for (int x = 0; x < kWidthPx; ++x)
            {
                bright += level(*picture, x, y) > 150.0;
                sum += level(*picture, x, y);
            }
        return std::pair{bright, sum / (225.0 * kWidthPx)};
    };
    const auto [lamps, night] = brightPixels(-14.0, 0.0);
    EXPECT_GT(lamps, 15);
    EXPECT_LT(lamps, 1500);
    EXPECT_LT(night, 30.0);
    terrain->material()->stateSet()->setDefine("PICTURE_LOW");
    EXPECT_GT(brightPixels(-14.0, 0.0).first, lamps / 2) << "at every quality";
    terrain->material()->stateSet()->removeDefine("PICTURE_LOW");
    EXPECT_GT(brightPixels(-14.0, 1.0).second, 1.3 * night) << "moonlight shows the ground";
    EXPECT_EQ(brightPixels(30.0, 1.0).second, brightPixels(30.0, 0.0).second)
        << "and by day there is none of it";
}

TEST(NightPaint, ATownIsLit)
{
    const auto terrain = plain({});
    terrain->material()->setCover(halves(GroundKind::urban, GroundKind::forest));
    osgSky::AtmosphereSettings settings = terrain->atmosphere()->settings();
    settings.sunDirectionWorld = osgSky::sunDirectionFromAngles(200.0, -14.0);
    EXPECT_TRUE(terrain->atmosphere()->setSettings(settings));
    const auto picture = fromAbove(terrain);
    EXPECT_GT(meanOf(*picture, 0, 200).x(), 2.0 * meanOf(*picture, 280, kWidthPx).x() + 3.0);
}

TEST(ImageryPaint, TheFinestOfSeveralWinsInAnyOrder)
{
    const auto layer = [](int side, double firstGrid, double lastGrid, osg::Vec4ub colour)
    {
        ImageryLayer made{new osg::Image, glm::dvec2(firstGrid), glm::dvec2(lastGrid)};
        made.image->allocateImage(side, side, 1, GL_RGBA, GL_UNSIGNED_BYTE);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                std::copy_n(colour.ptr(), 4, made.image->data(x, y));
        made.texelM = (lastGrid - firstGrid) * 250.0 / (side - 1);
        return made;
    };
    // Samples are 250 m apart: grid place 80 is at 20 000 m. Red everywhere, blue from 20 000 m on.
    const ImageryLayer coarse = layer(64, 0.0, 256.0, {200, 40, 40, 255});
    const ImageryLayer fine = layer(64, 80.0, 84.0, {40, 40, 200, 255});
    for (const auto& layers : {std::vector{coarse, fine}, std::vector{fine, coarse}})
    {
        const auto terrain = plain({});
        EXPECT_TRUE(terrain->material()->setImagery(layers));
        Camera camera(terrain);
        const auto picture = camera.picture({20000.0, 20500.0, 300.0}, -kUp, kNorth);
        const osg::Vec3d west = meanOf(*picture, 0, 230), east = meanOf(*picture, 300, kWidthPx);
        EXPECT_GT(west.x(), west.z() + 40.0);
        EXPECT_GT(east.z(), east.x() + 40.0);
        // The border is soft: two hundredths of 1000 m.
        const osg::Vec3d border = meanOf(*picture, 246, 249);
        EXPECT_GT(border.x(), east.x() + 10.0);
        EXPECT_GT(border.z(), west.z() + 10.0);
    }
}
