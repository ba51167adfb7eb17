// SPDX-License-Identifier: Apache-2.0
#include "measurement/view/ContactSheet.h"

#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include <osgOffscreen/PngFile>

using measurement::ContactSheetSettings;

namespace
{

class ContactSheet : public testing::Test
{
protected:
    void SetUp() override { std::filesystem::create_directories(_folder); }
    void TearDown() override { std::filesystem::remove_all(_folder); }

    /// A picture whose left half has one level and whose right half another.
    std::filesystem::path picture(const std::string& name, int left, int right, int widthPx = 64)
    {
        const osg::ref_ptr<osg::Image> image = new osg::Image;
        image->allocateImage(widthPx, 32, 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
        for (unsigned y = 0; y < 32; ++y)
            for (unsigned x = 0; x < static_cast<unsigned>(widthPx); ++x)
                for (int c = 0; c < 3; ++c)
                    image->data(x, y)[c] =
                        static_cast<unsigned char>(static_cast<int>(x) < widthPx / 2 ? left : right);
        EXPECT_TRUE(osgOffscreen::writePng(*image, _folder / name));
        return _folder / name;
    }

    const std::filesystem::path _folder =
        std::filesystem::temp_directory_path() / ("osgtrainer-sheet-" + std::to_string(getpid()));
};

} // namespace

TEST_F(ContactSheet, LaysFramesOutInRowsFromTheTopLeft)
{
    ContactSheetSettings settings;
    settings.columns = 2;
    settings.widthPx = 76;
    settings.gapPx = 4;
    const auto sheet = measurement::makeContactSheet(
        {picture("a.png", 10, 20), picture("b.png", 30, 40), picture("c.png", 50, 60)}, settings);
    ASSERT_TRUE(sheet) << sheet.error().message();
    const osg::Image& image = **sheet;
    ASSERT_EQ(image.s(), 76);
    ASSERT_EQ(image.t(), 4 + 2 * (16 + 4));
    const auto level = [&](unsigned x, unsigned fromTop)
    { return static_cast<int>(image.data(x, static_cast<unsigned>(image.t()) - 1 - fromTop)[0]); };
    EXPECT_EQ(level(0, 0), 255) << "the gap is white";
    EXPECT_EQ(level(5, 5), 10);
    EXPECT_EQ(level(4 + 31, 5), 20);
    EXPECT_EQ(level(4 + 32 + 4 + 1, 5), 30);
    EXPECT_EQ(level(5, 4 + 16 + 4 + 1), 50);
    EXPECT_EQ(level(4 + 32 + 4 + 1, 4 + 16 + 4 + 1), 255) << "no fourth frame";
}

TEST_F(ContactSheet, WhatCannotBeLaidOutIsAnError)
{
    EXPECT_FALSE(measurement::makeContactSheet({}, {}));
    EXPECT_FALSE(measurement::makeContactSheet({_folder / "missing.png"}, {}));
    EXPECT_FALSE(measurement::makeContactSheet({picture("a.png", 1, 2), picture("wide.png", 1, 2, 80)}, {}));
}

TEST_F(ContactSheet, FramesAreSpreadFromTheFirstToTheLast)
{
    EXPECT_EQ(measurement::contactSheetFrames(100, {2, 2, 0, 0}), (std::vector<std::size_t>{0, 33, 66, 99}));
    EXPECT_EQ(measurement::contactSheetFrames(3, {2, 2, 0, 0}), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(measurement::contactSheetFrames(1, {2, 2, 0, 0}), (std::vector<std::size_t>{0}));
    EXPECT_TRUE(measurement::contactSheetFrames(0, {2, 2, 0, 0}).empty());
}
