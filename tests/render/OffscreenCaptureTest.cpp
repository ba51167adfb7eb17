// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include <osgOffscreen/FrameCapture>
#include <osgOffscreen/ImageComparison>
#include <osgOffscreen/OffscreenViewer>
#include <osgOffscreen/PngFile>

#include "RenderedPicture.h"

using osgOffscreen::FrameCapture;
using osgOffscreen::OffscreenSettings;

namespace
{

/// A folder of this test, removed at its end.
class FolderOfTest
{
public:
    FolderOfTest()
        : path(std::filesystem::temp_directory_path() /
               ("osgtrainer-" + std::to_string(getpid()) + "-" +
                testing::UnitTest::GetInstance()->current_test_info()->name()))
    {
        std::filesystem::remove_all(path);
        std::filesystem::create_directories(path);
    }
    ~FolderOfTest()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    const std::filesystem::path path;
};

OffscreenSettings smallPicture()
{
    OffscreenSettings settings;
    settings.widthPx = 160;
    settings.heightPx = 90;
    return settings;
}

/// Moves the eye so that every frame differs.
void lookFrom(osgOffscreen::OffscreenViewer& viewer, int frame)
{
    viewer.camera().setViewMatrixAsLookAt({0.3 * frame, -10.0, 2.0}, {0.0, 0.0, 1.0}, {0.0, 0.0, 1.0});
}

std::filesystem::path frameFile(const std::filesystem::path& folder, int frame)
{
    return folder / ("frame_0000" + std::to_string(frame) + ".png");
}

} // namespace

TEST(FrameCapture, LeavesEveryFrameInOrder)
{
    const FolderOfTest folder;
    const auto viewer = rendered::viewerOf(rendered::smallScene(), smallPicture());
    ASSERT_NE(viewer, nullptr);
    auto capture = FrameCapture::begin(&viewer->context(), folder.path / "deep" / "er");
    ASSERT_TRUE(capture) << capture.error().message();
    for (int i = 0; i < 7; ++i)
    {
        lookFrom(*viewer, i);
        viewer->frame(i);
    }
    const auto count = (*capture)->finish();
    ASSERT_TRUE(count) << count.error().message();
    EXPECT_EQ(*count, 7U);
    for (int i = 0; i < 7; ++i)
    {
        const auto read = osgOffscreen::readPng(frameFile(folder.path / "deep" / "er", i));
        ASSERT_TRUE(read) << read.error().message();
        lookFrom(*viewer, i);
        const auto expected = viewer->picture(i);
        const auto difference = osgOffscreen::compareImages(**read, *expected);
        EXPECT_TRUE(difference.identical()) << "frame " << i << ": " << difference.message();
    }
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder.path / "deep" / "er"))
        files += entry.is_regular_file() ? 1 : 0;
    EXPECT_EQ(files, 7U) << "no temporary file may stay";
}

TEST(FrameCapture, RemovesTheFramesOfALongerCapture)
{
    const FolderOfTest folder;
    for (int i = 0; i < 5; ++i)
        std::ofstream(frameFile(folder.path, i)) << "old";
    std::ofstream(folder.path / "frame_notes.txt") << "not a frame";
    const auto viewer = rendered::viewerOf(rendered::smallScene(), smallPicture());
    ASSERT_NE(viewer, nullptr);
    auto capture = FrameCapture::begin(&viewer->context(), folder.path);
    ASSERT_TRUE(capture) << capture.error().message();
    viewer->frame(0.0);
    viewer->frame(1.0);
    ASSERT_TRUE((*capture)->finish());
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(std::filesystem::exists(frameFile(folder.path, i)), i < 2) << i;
    EXPECT_TRUE(std::filesystem::exists(folder.path / "frame_notes.txt"));
}

TEST(FrameCapture, AFolderThatCannotBeMadeIsAnError)
{
    const FolderOfTest folder;
    std::ofstream(folder.path / "file") << "in the way";
    const auto viewer = rendered::viewerOf(rendered::smallScene(), smallPicture());
    ASSERT_NE(viewer, nullptr);
    const auto capture = FrameCapture::begin(&viewer->context(), folder.path / "file" / "frames");
    ASSERT_FALSE(capture);
    EXPECT_NE(capture.error().place.find("frames"), std::string::npos);
}

TEST(FrameCapture, AFolderThatGoesAwayIsAnErrorAndLeavesNothing)
{
    const FolderOfTest folder;
    const auto viewer = rendered::viewerOf(rendered::smallScene(), smallPicture());
    ASSERT_NE(viewer, nullptr);
    auto capture = FrameCapture::begin(&viewer->context(), folder.path / "frames");
    ASSERT_TRUE(capture);
    std::filesystem::remove_all(folder.path / "frames");
    for (int i = 0; i < 30; ++i)
        viewer->frame(i); // more than the queue holds: drawing must not block
    const auto count = (*capture)->finish();
    ASSERT_FALSE(count);
    EXPECT_NE(count.error().place.find("frame_00000.png"), std::string::npos)
        << "the first failure is the one told";
    EXPECT_FALSE((*capture)->outcome());
}

TEST(PngFile, AFolderWithoutPermissionIsAnError)
{
    if (geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
    const FolderOfTest folder;
    std::filesystem::permissions(folder.path,
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(4, 4, 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
    EXPECT_FALSE(osgOffscreen::writePng(*image, folder.path / "a.png"));
    std::filesystem::permissions(folder.path, std::filesystem::perms::owner_all);
}

TEST(PngFile, ADirectoryInThePlaceOfTheFileIsAnErrorAndLeavesNoTemporary)
{
    const FolderOfTest folder;
    std::filesystem::create_directories(folder.path / "a.png" / "inside");
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(4, 4, 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
    const auto written = osgOffscreen::writePng(*image, folder.path / "a.png");
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().message().find("a.png"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(folder.path / "a.png.part"));
}

TEST(PngFile, AFullDiskIsAnError)
{
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const FolderOfTest folder;
    std::filesystem::create_symlink("/dev/full", folder.path / "a.png.part");
    const osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(64, 64, 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
    const auto written = osgOffscreen::writePng(*image, folder.path / "a.png");
    ASSERT_FALSE(written);
    EXPECT_FALSE(std::filesystem::exists(folder.path / "a.png"));
}

TEST(PngFile, WhatIsNotAPictureIsAnError)
{
    const FolderOfTest folder;
    EXPECT_FALSE(osgOffscreen::readPng(folder.path / "missing.png"));
    std::ofstream(folder.path / "text.png") << "no picture";
    EXPECT_FALSE(osgOffscreen::readPng(folder.path / "text.png"));
}
