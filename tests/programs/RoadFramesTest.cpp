// SPDX-License-Identifier: Apache-2.0
// Consecutive frames of drives differ by no more than those of a render at a tenth of the error target, and one level: nothing pops
// or shimmers that a finer mesh would not show. OSGTRAINER_EVERY_FRAME=1 draws 24 frames of five networks from two eyes, which takes
// some minutes, and prints a table.
#include <algorithm>
#include <cstdlib>
#include <iostream>

#include <osgOffscreen/PngFile>

#include "Playing.h"
#include "RealData.h"

namespace
{

constexpr double kMostLevels = 1.0;

/// The mean difference of two images, levels of 255.
double differenceOf(const osg::Image& a, const osg::Image& b)
{
    const std::size_t bytes = a.getTotalSizeInBytes();
    if (bytes != b.getTotalSizeInBytes()) return 255.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < bytes; ++i)
        sum += std::abs(static_cast<int>(a.data()[i]) - static_cast<int>(b.data()[i]));
    return sum / static_cast<double>(bytes);
}

/// Where a drive is looked at.
struct Shot
{
    std::string name;
    std::filesystem::path network;
    std::string eye = "driver";
    std::string size = "480x270";
    int frames = 24;
};

std::vector<osg::ref_ptr<osg::Image>> framesOf(const Workplace& place, const Shot& shot,
                                               const std::string& tolerance)
{
    const std::string folder = shot.name + shot.eye + tolerance;
    playedAs(place, folder, {"tour", shot.network.string()},
             {"--eye", shot.eye, "--duration", "8", "--tolerance", tolerance, "--size", shot.size, "--frames",
              std::to_string(shot.frames)});
    std::vector<osg::ref_ptr<osg::Image>> images;
    for (const auto& [name, bytes] : bytesIn(place.path(folder)))
        if (auto image = osgOffscreen::readPng(std::filesystem::path(place.path(folder)) / name))
            images.push_back(*image);
    EXPECT_EQ(images.size(), static_cast<std::size_t>(shot.frames));
    return images;
}

std::vector<double> stepsOf(const std::vector<osg::ref_ptr<osg::Image>>& images)
{
    std::vector<double> steps;
    for (std::size_t i = 1; i < images.size(); ++i)
        steps.push_back(differenceOf(*images[i - 1], *images[i]));
    return steps;
}

double meanOf(const std::vector<double>& values)
{
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

/// By how much the steps of one render are greater than those of the other, at most.
double worstExcess(const std::vector<double>& steps, const std::vector<double>& fine)
{
    double worst = -255.0;
    for (std::size_t i = 0; i < std::min(steps.size(), fine.size()); ++i)
        worst = std::max(worst, steps[i] - fine[i]);
    return worst;
}

TEST(RoadFrames, DifferNoMoreThanThoseOfAFineRender)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, "openscenario/esmini/xodr/curves_elevation.xodr");
    const Workplace place;
    const Shot shot{"curves", file, "driver", "160x90", 5};
    auto frames = framesOf(place, shot, "1");
    const std::vector<double> fine = stepsOf(framesOf(place, shot, "0.1"));
    EXPECT_LE(worstExcess(stepsOf(frames), fine), kMostLevels);
    // The mutation: a frame that shows another moment, as a pop does another shape.
    std::swap(frames[1], frames[4]);
    EXPECT_GT(worstExcess(stepsOf(frames), fine), kMostLevels);
}

TEST(RoadFrames, OfFiveNetworksFromTwoEyesDifferNoMore)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "openscenario/esmini/xodr");
    if (!std::getenv("OSGTRAINER_EVERY_FRAME")) GTEST_SKIP() << "takes minutes: set OSGTRAINER_EVERY_FRAME";
    const Workplace place;
    for (const char* name :
         {"e6mini", "fabriksgatan", "multi_intersections", "soderleden", "curves_elevation"})
        for (const char* eye : {"driver", "above"})
        {
            const Shot shot{name, folder / (std::string(name) + ".xodr"), eye};
            const auto steps = stepsOf(framesOf(place, shot, "1")),
                       fine = stepsOf(framesOf(place, shot, "0.1"));
            std::cout << name << ' ' << eye << ": mean " << meanOf(steps) << ", fine " << meanOf(fine)
                      << ", worst excess " << worstExcess(steps, fine) << '\n';
            EXPECT_LE(worstExcess(steps, fine), kMostLevels) << name << ' ' << eye;
        }
}

} // namespace
