// SPDX-License-Identifier: Apache-2.0
// A database of stock osgTerrain nodes in stock osgviewer, in a window.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include <osgOffscreen/PngFile>

#include "TechniquePictures.h"

namespace
{

using namespace techniquepictures;

class Osgviewer : public testing::Test
{
protected:
    void SetUp() override
    {
        std::filesystem::create_directories(_folder);
        techniquescene::writePagedDatabase(_folder, 30000.0);
        const osg::Matrixd eye = osg::Matrixd::inverse(osg::Matrixd::lookAt(
            osg::Vec3d(-300, -600, 1500), osg::Vec3d(1900, 1900, 200), osg::Vec3d(0, 0, 1)));
        std::ofstream path(_folder / "eye.path");
        for (const int second : {0, 1000})
            path << second << ' ' << eye.getTrans().x() << ' ' << eye.getTrans().y() << ' '
                 << eye.getTrans().z() << ' ' << eye.getRotate().x() << ' ' << eye.getRotate().y() << ' '
                 << eye.getRotate().z() << ' ' << eye.getRotate().w() << '\n';
    }
    void TearDown() override { std::filesystem::remove_all(_folder); }

    /// What osgviewer shows of a file; null: it failed.
    osg::ref_ptr<osg::Image> shows(const std::string& file,
                                   const std::string& threading = "SingleThreaded") const
    {
        const std::filesystem::path picture = _folder / "window.png";
        std::filesystem::remove(picture);
        const std::string command = std::string(OSGTRAINER_OSGVIEWER_SHOT) + " '" + OSGTRAINER_PLUGIN_FOLDER +
                                    "' '" + (_folder / file).string() + "' '" +
                                    (_folder / "eye.path").string() + "' '" + picture.string() + "' " +
                                    threading;
        EXPECT_EQ(std::system(command.c_str()), 0) << command; // NOLINT(concurrency-mt-unsafe)
        const auto image = osgOffscreen::readPng(picture);
        return image ? *image : nullptr;
    }

    /// Returns what stock osgTerrain draws of the database; it takes seconds, so both tests share it.
    osg::ref_ptr<osg::Image> stock() const
    {
        static const osg::ref_ptr<osg::Image> image = shows("database.osgb");
        return image;
    }

    std::filesystem::path _folder =
        std::filesystem::temp_directory_path() / ("osgviewer." + std::to_string(::getpid()));
};

} // namespace

TEST_F(Osgviewer, ShowsADatabaseWithTheTechniqueAsItDoesWithout)
{
    const auto expected = stock();
    ASSERT_TRUE(expected);
    const std::size_t pixels = static_cast<std::size_t>(expected->s()) * expected->t();
    EXPECT_LT(magentaPixels(*expected), pixels / 2) << "stock osgviewer shows land";
    for (const char* threading : {"SingleThreaded", "DrawThreadPerContext"})
    {
        const auto found = shows("database.osgb.roam", threading);
        ASSERT_TRUE(found);
        const Unlikeness difference = unlikeness(*found, *expected);
        EXPECT_LT(difference.mean, 3.0) << threading;
        EXPECT_LT(difference.shareFar, 0.035) << threading;
        EXPECT_GT(difference.mean, 0.0) << "it would be stock osgTerrain that has drawn it";
    }
}

TEST_F(Osgviewer, AnotherDatabaseWouldShow)
{
    // The mutation: the children, which are what is drawn, are not there to be paged in.
    const auto expected = stock();
    std::filesystem::remove(_folder / "children.osgb");
    const auto found = shows("database.osgb.roam");
    ASSERT_TRUE(found && expected);
    EXPECT_GT(unlikeness(*found, *expected).mean, 6.0);
}
