// SPDX-License-Identifier: Apache-2.0
// Furrows are relief along a field's rows: light from across them shows it, light along them does not, and
// from afar nothing does.
#include <cmath>

#include <gtest/gtest.h>

#include "FeatureScene.h"

namespace
{

using namespace osgTerrainROAM;
using namespace featurescene;

/// A field that is long from west to east, as its rows are.
core::GroundFeature field(core::Crop crop)
{
    core::GroundFeature area;
    area.isArea = true;
    area.style.kind = core::FeatureKind::field;
    area.style.crop = crop;
    area.style.isCropKnown = true;
    area.paths = {{{700.0, 19900.0}, {1300.0, 19900.0}, {1300.0, 20100.0}, {700.0, 20100.0}}};
    return area;
}

osg::ref_ptr<osg::Image> litFrom(double azimuthDeg, core::Crop crop, double heightM)
{
    const auto terrain = plain({field(crop)});
    osgSky::AtmosphereSettings settings = terrain->atmosphere()->settings();
    settings.sunDirectionWorld = osgSky::sunDirectionFromAngles(azimuthDeg, 35.0);
    EXPECT_TRUE(terrain->atmosphere()->setSettings(settings));
    Camera camera(terrain);
    return camera.picture({1000.0, 20000.0, heightM}, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0});
}

/// Mean difference of pictures with the sun on opposite sides, in levels.
double difference(double azimuthDeg, core::Crop crop, double heightM)
{
    const auto a = litFrom(azimuthDeg, crop, heightM), b = litFrom(azimuthDeg + 180.0, crop, heightM);
    double sum = 0.0;
    for (int y = 0; y < kHeightPx; ++y)
        for (int x = 0; x < kWidthPx; ++x)
            sum += std::abs(level(*a, x, y) - level(*b, x, y));
    return sum / (kWidthPx * kHeightPx);
}

} // namespace

TEST(Furrows, AreReliefAlongTheRows)
{
    const double across = difference(0.0, core::Crop::rowCrop, 3.0);
    EXPECT_GT(across, 1.3 * difference(90.0, core::Crop::rowCrop, 3.0));
    EXPECT_LT(difference(0.0, core::Crop::grassland, 3.0),
              1.15 * difference(90.0, core::Crop::grassland, 3.0))
        << "the control: grass looks the same from all sides";
}

TEST(Furrows, FadeOutBeforeAPixelIsAsWideAsTheyAre)
{
    const double across = difference(0.0, core::Crop::rowCrop, 150.0);
    EXPECT_NEAR(across, difference(90.0, core::Crop::rowCrop, 150.0), 0.2 * across);
}
