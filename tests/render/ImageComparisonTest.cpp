// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgOffscreen/ImageComparison>

using osgOffscreen::compareImages;
using osgOffscreen::differenceImage;
using osgOffscreen::ImageDifference;

namespace
{

osg::ref_ptr<osg::Image> grey(int width, int height, unsigned char level = 100)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(width, height, 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
    std::fill_n(image->data(), image->getTotalSizeInBytes(), level);
    return image;
}

} // namespace

TEST(ImageComparison, FindsNothingInTwoCopies)
{
    const ImageDifference difference = compareImages(*grey(7, 5), *grey(7, 5));
    EXPECT_TRUE(difference.identical());
    EXPECT_TRUE(difference.within(0, 0));
    EXPECT_EQ(difference.message(), "identical");
}

TEST(ImageComparison, CountsPixelsNotChannelsAndFindsTheFirstFromTheTop)
{
    const auto a = grey(7, 5);
    const auto b = grey(7, 5);
    b->data(2, 4)[0] = 101; // top row
    b->data(2, 4)[2] = 90;  // the same pixel
    b->data(0, 0)[1] = 103; // bottom row
    const ImageDifference difference = compareImages(*a, *b);
    EXPECT_EQ(difference.differingPixels, 2U);
    EXPECT_EQ(difference.largestStep, 10);
    EXPECT_EQ(difference.firstXPx, 2);
    EXPECT_EQ(difference.firstYFromTopPx, 0);
}

TEST(ImageComparison, BoundsHoldAtTheirEdgeAndNotBeyond)
{
    const auto a = grey(8, 8);
    const auto b = grey(8, 8);
    for (unsigned x = 0; x < 8; ++x)
        b->data(x, 3)[0] = 101;
    EXPECT_TRUE(compareImages(*a, *b).within(8, 1));
    EXPECT_FALSE(compareImages(*a, *b).within(7, 1)) << "one pixel too many must be seen";
    b->data(0, 3)[0] = 102;
    EXPECT_FALSE(compareImages(*a, *b).within(8, 1)) << "one level too many must be seen";
}

TEST(ImageComparison, DoesNotTakeAnotherShapeForTheSamePicture)
{
    const ImageDifference difference = compareImages(*grey(7, 5), *grey(5, 7));
    EXPECT_FALSE(difference.sameShape);
    EXPECT_FALSE(difference.identical());
    EXPECT_FALSE(difference.within(1000, 255));
    EXPECT_EQ(differenceImage(*grey(7, 5), *grey(5, 7)), nullptr);
}

TEST(ImageComparison, DifferenceImageShowsWhereAndNothingElse)
{
    const auto a = grey(4, 4);
    const auto b = grey(4, 4);
    b->data(1, 2)[1] = 105;
    const auto shown = differenceImage(*a, *b);
    EXPECT_EQ(shown->data(1, 2)[1], 255);
    EXPECT_EQ(shown->data(1, 2)[0], 0);
    EXPECT_EQ(shown->data(0, 0)[1], 0);
}
