// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/Paint.h"

#include <bit>
#include <cstdlib>

#include <gtest/gtest.h>

#include "scenery/models/looks/BuiltInLooks.h"
#include "scenery/models/paint/MipChain.h"

using namespace scenery::models;

namespace
{

/// Returns the mean difference between two columns (or rows), over all rows (columns) and colours.
double stepBetween(const Picture& p, int first, int second, bool columns)
{
    const int length = columns ? p.heightPx : p.widthPx;
    double sum = 0.0;
    for (int i = 0; i < length; ++i)
        for (int c = 0; c < 3; ++c)
            sum += std::abs((columns ? p.at(first, i) : p.at(i, first))[c] -
                            (columns ? p.at(second, i) : p.at(i, second))[c]);
    return sum / (3.0 * length);
}

/// The largest difference between neighbouring columns (rows) inside the picture, and that across its border.
bool repeatsWithoutSeam(const Picture& p)
{
    for (const bool columns : {true, false})
    {
        const int size = columns ? p.widthPx : p.heightPx;
        double largest = 0.0;
        for (int i = 0; i + 1 < size; ++i)
            largest = std::max(largest, stepBetween(p, i, i + 1, columns));
        if (stepBetween(p, size - 1, 0, columns) > 1.1 * largest) return false;
    }
    return true;
}

} // namespace

TEST(Paint, PicturesAreWholeAndPowersOfTwo)
{
    for (int i = 0; i < static_cast<int>(Painting::count); ++i)
    {
        const auto painting = static_cast<Painting>(i);
        const auto look = builtInLook("van");
        const Picture picture = paint(painting, painting == Painting::vehicle ? look.get() : nullptr);
        EXPECT_TRUE(std::has_single_bit(static_cast<unsigned>(picture.widthPx))) << i;
        EXPECT_TRUE(std::has_single_bit(static_cast<unsigned>(picture.heightPx))) << i;
        EXPECT_EQ(picture.rgba.size(),
                  4U * static_cast<std::size_t>(picture.widthPx) * static_cast<std::size_t>(picture.heightPx))
            << i;
    }
}

TEST(Paint, AlwaysPaintsTheSame)
{
    for (const Painting painting : {Painting::oakLeaves, Painting::wheel, Painting::birchBark})
        EXPECT_EQ(paint(painting), paint(painting));
    const auto saloon = builtInLook("saloon"), estate = builtInLook("estate");
    EXPECT_EQ(paint(Painting::vehicle, saloon.get()), paint(Painting::vehicle, saloon.get()));
    EXPECT_NE(paint(Painting::vehicle, saloon.get()), paint(Painting::vehicle, estate.get()));
    EXPECT_NE(paint(Painting::oakLeaves), paint(Painting::bushLeaves));
}

TEST(Paint, WallsRoofsAndBarksRepeatWithoutASeam)
{
    for (const Painting painting :
         {Painting::plaster, Painting::bricks, Painting::sheetMetal, Painting::planks, Painting::roofTiles,
          Painting::roofMetal, Painting::oakBark, Painting::pineBark})
        EXPECT_TRUE(repeatsWithoutSeam(paint(painting))) << static_cast<int>(painting);
}

TEST(Paint, ASeamWouldBeSeen)
{
    Picture picture = paint(Painting::plaster);
    for (int y = 0; y < picture.heightPx; ++y) // brighter from left to right, by a tenth
        for (int x = 0; x < picture.widthPx; ++x)
            for (int c = 0; c < 3; ++c)
                picture.at(x, y)[c] =
                    static_cast<std::uint8_t>(picture.at(x, y)[c] - 25 + 25 * x / picture.widthPx);
    EXPECT_FALSE(repeatsWithoutSeam(picture));
}

TEST(MipChain, KeepsTheCoverageOfLeaves)
{
    for (const Painting painting : {Painting::oakLeaves, Painting::birchLeaves, Painting::spruceNeedles})
    {
        const Picture picture = paint(painting);
        const std::vector<Picture> kept = mipChain(picture, true);
        const std::vector<Picture> plain = mipChain(picture, false);
        EXPECT_EQ(kept.size(), 10U);
        for (const std::size_t level : {2U, 4U, 5U})
            EXPECT_NEAR(coverageOf(kept[level]), coverageOf(picture), 0.04) << level;
        EXPECT_EQ(kept.back().widthPx, 1);
        EXPECT_EQ(plain.size(), kept.size());
    }
}

TEST(MipChain, PlainMeansDoNotKeepIt)
{
    const Picture leaves = paint(Painting::oakLeaves);
    EXPECT_GT(std::abs(coverageOf(mipChain(leaves, false)[5]) - coverageOf(leaves)), 0.04);
    EXPECT_EQ(coverageOf(mipChain(paint(Painting::spruceNeedles), false)[8]), 0.0);
}

TEST(MipChain, IsTheMeanOfFour)
{
    const Picture four{2, 2, {0, 10, 20, 255, 40, 10, 20, 255, 80, 10, 20, 255, 120, 10, 20, 255}};
    const std::vector<Picture> chain = mipChain(four, false);
    ASSERT_EQ(chain.size(), 2U);
    EXPECT_EQ(chain[1].rgba, (std::vector<std::uint8_t>{60, 10, 20, 255}));
}
