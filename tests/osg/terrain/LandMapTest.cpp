// SPDX-License-Identifier: Apache-2.0
#include "material/LandMap.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/edit/TileEditor.h>

#include "SyntheticField.h"
#include "material/DetailImages.h"
#include "material/GrainImage.h"
#include "material/NormalMap.h"
#include "material/SkyVisibility.h"
#include "material/TileableNoise.h"
#include "material/WaterMask.h"

namespace
{

using namespace osgTerrainROAM;

core::HeightField fieldOf(int columns, int rows, double spacingM,
                          const std::function<double(int, int)>& height)
{
    core::HeightField field;
    field.columns = columns;
    field.rows = rows;
    field.spacingEastM = field.spacingNorthM = spacingM;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            field.heightsM.push_back(static_cast<float>(height(column, row)));
    return field;
}

core::PlacedTile planar(core::HeightField field)
{
    return core::PlacedTile(std::move(field), core::Placement::planar);
}

osg::ref_ptr<osg::Image> landOf(const core::PlacedTile& tile, const Climate& climate)
{
    const MapGrid grid(tile);
    return landMap(tile, grid, climate, *normalMap(tile, grid));
}

double vegetationOf(const core::PlacedTile& tile, const Climate& climate, int x, int y)
{
    return landOf(tile, climate)->data(x, y)[0] / 255.0;
}

double snowOf(const core::PlacedTile& tile, const Climate& climate)
{
    return landOf(tile, climate)->data(16, 16)[1] / 255.0;
}

} // namespace

TEST(NormalMap, IsThePlanesNormalOnAPlane)
{
    const auto tile = planar(fieldOf(9, 7, 10.0, [](int c, int r) { return 3.0 * c - 2.0 * r; }));
    const auto image = normalMap(tile, MapGrid(tile));
    ASSERT_EQ(image->s(), 9);
    ASSERT_EQ(image->t(), 7);
    const double length = std::sqrt(0.3 * 0.3 + 0.2 * 0.2 + 1.0);
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 9; ++x)
        {
            EXPECT_NEAR(tiltAt(*image, x, y).x, -0.3 / length, 1e-4);
            EXPECT_NEAR(tiltAt(*image, x, y).y, 0.2 / length, 1e-4);
        }
}

TEST(NormalMap, KeepsWhatEightBitsWouldLose)
{
    const auto tile = planar(fieldOf(9, 9, 100.0, [](int c, int) { return 0.1 * c; }));
    EXPECT_NEAR(tiltAt(*normalMap(tile, MapGrid(tile)), 4, 4).x, -0.001, 4e-5);
}

TEST(TileableNoise, WrapsAndHasItsMean)
{
    const TileableNoise noise(128, {4, 4, 0.5, 7});
    double sum = 0.0, seam = 0.0, inside = 0.0;
    for (int y = 0; y < 128; ++y)
    {
        seam += std::abs(noise.at(127, y) - noise.at(128, y));
        inside += std::abs(noise.at(63, y) - noise.at(64, y));
        for (int x = 0; x < 128; ++x)
            sum += noise.at(x, y);
    }
    EXPECT_NEAR(sum / (128 * 128), 0.5, 0.01);
    EXPECT_LT(seam, 2.0 * inside) << "no step where it repeats";
    EXPECT_FLOAT_EQ(noise.sample(0.3, 0.9), noise.sample(1.3, -0.1));
}

TEST(GrainImage, EveryChannelHasMeanOneHalf)
{
    const auto image = grainImage();
    for (int channel = 0; channel < 4; ++channel)
    {
        double sum = 0.0;
        for (int i = 0; i < image->s() * image->t(); ++i)
            sum += image->data()[4 * i + channel];
        EXPECT_NEAR(sum / (image->s() * image->t()) / 255.0, 0.5, 0.01) << channel;
    }
}

TEST(DetailImages, EverySurfaceHasMeanOneHalfAndNoSeam)
{
    for (int detail = 0; detail < kDetails; ++detail)
    {
        const auto image = detailImage(static_cast<Detail>(detail));
        const int side = image->s();
        for (int channel = 0; channel < 4; ++channel)
        {
            double sum = 0.0, seam = 0.0, inside = 0.0;
            for (int y = 0; y < side; ++y)
            {
                const auto at = [&](int x) { return static_cast<double>(image->data(x, y)[channel]); };
                seam += std::abs(at(side - 1) - at(0));
                inside += std::abs(at(side / 2) - at(side / 2 - 1));
                for (int x = 0; x < side; ++x)
                    sum += at(x);
            }
            EXPECT_NEAR(sum / (side * side) / 255.0, 0.5, 0.02) << detail << ' ' << channel;
            EXPECT_LT(seam, 2.5 * inside) << detail << ' ' << channel;
        }
    }
}

/// Slopes are those of the heights: a normal that points the other way would light blades from below.
TEST(DetailImages, SlopesRiseWhereHeightsDo)
{
    const auto image = detailImage(Detail::stones);
    double along = 0.0, turned = 0.0;
    for (int y = 0; y < image->t(); ++y)
        for (int x = 1; x + 1 < image->s(); ++x)
        {
            const double rise = image->data(x + 1, y)[2] - image->data(x - 1, y)[2];
            along += rise * (image->data(x, y)[0] - 127.5);
            turned += rise * (image->data(x, y)[1] - 127.5);
        }
    EXPECT_GT(along, 0.0);
    EXPECT_LT(std::abs(turned), 0.2 * along) << "the mutation: x for y";
}

TEST(WaterMask, FindsSeaAndLakeButNoTerrace)
{
    // West: sea. Middle: a lake at 50 m in a bowl. East: a terrace with a lower side.
    const auto tile = planar(fieldOf(120, 60, 30.0,
                                     [](int c, int r)
                                     {
                                         if (c < 20) return 0.0;
                                         const double bowl = std::hypot(c - 50, r - 30);
                                         if (c < 80) return bowl < 12 ? 50.0 : 38.0 + bowl;
                                         return c < 95 ? 80.0 : 60.0 - c * 0.1 - r * 0.01;
                                     }));
    const MapGrid grid(tile);
    const auto mask = waterMask(mapHeights(tile, grid), grid, 0.0, true);
    const auto at = [&](int x, int y) { return mask[static_cast<std::size_t>(y) * grid.width + x]; };
    EXPECT_EQ(at(5, 30), 255);
    EXPECT_EQ(at(50, 30), 255);
    EXPECT_EQ(at(88, 30), 0);
    EXPECT_EQ(at(110, 30), 0);
    EXPECT_GT(at(20, 30), 0) << "the shore";
    EXPECT_LT(at(20, 30), 128);
}

/// A road's bed over a slope: level, and no lake.
TEST(WaterMask, FindsNoneWhereEditsHaveLevelledTheGround)
{
    const auto tile = std::make_shared<core::RoamTile>(
        core::PlacedTile(fieldOf(60, 60, 30.0, [](int c, int r) { return 103.0 + c + 0.3 * r; }),
                         core::PlacedTileOptions{.placement = core::Placement::planar, .gridExponent = 1}));
    std::vector<core::HeightChange> level;
    for (int column = 40; column < 80; ++column)
        for (int row = 40; row < 80; ++row)
            level.push_back({{column, row}, 100.0f});
    const auto waterOf = [](const core::PlacedTile& of, const Climate& climate)
    {
        const MapGrid grid(of);
        return int(landMap(of, grid, climate, *normalMap(of, grid))->data(30, 30)[2]);
    };
    core::TileEditor editor(tile);
    ASSERT_TRUE(editor.apply(level, core::TileEditor::Between::stays));
    EXPECT_EQ(waterOf(tile->tile, Climate{}), 0);

    // The same ground as data is a lake, unless its maker says that there is none.
    const auto data = planar(fieldOf(60, 60, 30.0,
                                     [](int c, int r)
                                     {
                                         const bool isLake = c >= 20 && c < 40 && r >= 20 && r < 40;
                                         return isLake ? 100.0 : 103.0 + c + 0.3 * r;
                                     }));
    EXPECT_EQ(waterOf(data, Climate{}), 255);
    EXPECT_EQ(waterOf(data, Climate{.water = core::WaterRule::none}), 0);
    EXPECT_EQ(waterOf(data, Climate{.water = core::WaterRule::sea}), 0);
    EXPECT_EQ(waterOf(data, Climate{.seaLevelM = 101.0, .water = core::WaterRule::sea}), 255);
    EXPECT_EQ(waterOf(data, Climate{.seaLevelM = 101.0, .water = core::WaterRule::none}), 0);
}

/// Where there is no ground, the heights that stand for it are those of the nearest: flat.
TEST(WaterMask, FindsNoneBesideHoles)
{
    auto field = fieldOf(120, 60, 30.0, [](int c, int r) { return c < 60 ? 103.0 + c + 0.3 * r : 160.0; });
    const auto landOf = [](const core::PlacedTile& tile)
    {
        const MapGrid grid(tile);
        const auto image = landMap(tile, grid, Climate{}, *normalMap(tile, grid));
        int most = 0;
        for (int y = 0; y < grid.height; ++y)
            for (int x = 0; x < 60; ++x)
                most = std::max(most, int(image->data(x, y)[2]));
        return most;
    };
    EXPECT_GT(landOf(planar(field)), 0) << "a lake, if it were there";
    std::vector<std::uint8_t> isThere;
    for (int r = 0; r < 60; ++r)
        for (int c = 0; c < 120; ++c)
            isThere.push_back(c < 60);
    field.mask = core::SampleMask(isThere, 120, 60);
    EXPECT_EQ(landOf(planar(field)), 0);
}

TEST(SkyVisibility, ValleysSeeLessSkyThanRidges)
{
    const auto tile = planar(fieldOf(128, 128, 30.0, [](int c, int) { return 300.0 * std::cos(c * 0.2); }));
    const MapGrid grid(tile);
    const MapField hollow = hollowness(mapHeights(tile, grid), grid, 30.0);
    const float valley = hollow[64 * 128 + 47]; // cos(9.4) = -1
    const float ridge = hollow[64 * 128 + 63];  // cos(12.6) = 1
    EXPECT_LT(skyVisibility(valley), skyVisibility(ridge) - 0.2f);
    EXPECT_GE(skyVisibility(1e6f), 0.25f);
    EXPECT_LE(skyVisibility(-1e6f), 1.0f);
}

TEST(LandMap, TreesEndAndSnowBeginsByHeight)
{
    const Climate climate = climateAt(46.5, 8.5);
    const auto flatAt = [](double height)
    { return planar(fieldOf(33, 33, 90.0, [=](int c, int) { return height + 20.0 * c; })); };
    EXPECT_GT(vegetationOf(flatAt(1000), climate, 16, 16), 0.55);
    EXPECT_LT(vegetationOf(flatAt(2900), climate, 16, 16), 0.45);
    EXPECT_LT(snowOf(flatAt(1000), climate), 0.05);
    EXPECT_GT(snowOf(flatAt(3600), climate), 0.9);
}

TEST(LandMap, CliffsAndDesertsAreBare)
{
    const Climate humid = climateAt(46.5, 8.5);
    const Climate dry = climateAt(25.0, 10.0);
    const auto gentle = planar(fieldOf(33, 33, 30.0, [](int c, int) { return 800.0 + 6.0 * c; }));
    const auto cliff = planar(fieldOf(33, 33, 30.0, [](int c, int) { return 800.0 + 75.0 * c; }));
    const double wood = vegetationOf(gentle, humid, 16, 16);
    EXPECT_LT(vegetationOf(cliff, humid, 16, 16), wood - 0.3);
    EXPECT_LT(vegetationOf(gentle, dry, 16, 16), wood - 0.3);
}

TEST(LandMap, IsTheSameEveryTime)
{
    const auto tile = planar(testsupport::hills(100, 80));
    const Climate climate = climateAt(46.5, 8.5);
    const auto one = landOf(tile, climate);
    const auto two = landOf(tile, climate);
    EXPECT_EQ(std::memcmp(one->data(), two->data(), one->getTotalSizeInBytes()), 0);
}
