// SPDX-License-Identifier: Apache-2.0
// Consecutive frames of drives differ by no more than those of a render at a tenth of the error target, and one level, and in no
// square of 10 pixels by much more: nothing pops or shimmers that a finer mesh would not show. OSGTRAINER_EVERY_FRAME=1 draws 24
// frames of ten networks from two eyes, which takes a quarter of an hour, and prints a table.
#include <algorithm>
#include <cstdlib>
#include <iostream>

#include <osgOffscreen/PngFile>

#include "Playing.h"
#include "RealData.h"

namespace
{

constexpr double kMostLevels = 1.0;
constexpr double kMostLevelsOfSquare = 6.0; // a sign of 5 × 5 pixels that appears
constexpr int kSquarePx = 10;

/// How much two images differ, levels of 255.
struct Difference
{
    std::vector<double> squares; ///< mean of each square of kSquarePx
    double mean = 0.0;
};

Difference differenceOf(const osg::Image& a, const osg::Image& b)
{
    Difference difference;
    const int across = a.s() / kSquarePx, up = a.t() / kSquarePx;
    if (a.s() != b.s() || a.t() != b.t() || a.getPixelSizeInBits() != b.getPixelSizeInBits())
        return {{}, 255.0};
    const int channels = static_cast<int>(a.getPixelSizeInBits() / 8);
    difference.squares.resize(static_cast<std::size_t>(across * up));
    for (int y = 0; y < up * kSquarePx; ++y)
        for (int byte = 0; byte < across * kSquarePx * channels; ++byte)
            difference
                .squares[static_cast<std::size_t>(y / kSquarePx * across + byte / (kSquarePx * channels))] +=
                std::abs(static_cast<int>(a.data(0, y)[byte]) - static_cast<int>(b.data(0, y)[byte])) /
                static_cast<double>(kSquarePx * kSquarePx * channels);
    for (const double square : difference.squares)
        difference.mean += square / static_cast<double>(difference.squares.size());
    return difference;
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
             {"--eye", shot.eye, "--interior", "off", "--duration", "8", "--tolerance", tolerance, "--size",
              shot.size, "--frames", std::to_string(shot.frames)});
    std::vector<osg::ref_ptr<osg::Image>> images;
    for (const auto& [name, bytes] : bytesIn(place.path(folder)))
        if (auto image = osgOffscreen::readPng(std::filesystem::path(place.path(folder)) / name))
            images.push_back(*image);
    EXPECT_EQ(images.size(), static_cast<std::size_t>(shot.frames));
    return images;
}

std::vector<Difference> stepsOf(const std::vector<osg::ref_ptr<osg::Image>>& images)
{
    std::vector<Difference> steps;
    for (std::size_t i = 1; i < images.size(); ++i)
        steps.push_back(differenceOf(*images[i - 1], *images[i]));
    return steps;
}

double meanOf(const std::vector<Difference>& steps)
{
    double sum = 0.0;
    for (const Difference& step : steps)
        sum += step.mean;
    return sum / static_cast<double>(steps.size());
}

/// By how much the steps of one render are greater than those of the other, at most.
struct Excess
{
    double ofMean = -255.0, ofSquare = -255.0;

    bool isAllowed() const { return ofMean <= kMostLevels && ofSquare <= kMostLevelsOfSquare; }
};

Excess worstExcess(const std::vector<Difference>& steps, const std::vector<Difference>& fine)
{
    Excess worst;
    for (std::size_t i = 0; i < std::min(steps.size(), fine.size()); ++i)
    {
        worst.ofMean = std::max(worst.ofMean, steps[i].mean - fine[i].mean);
        for (std::size_t k = 0; k < std::min(steps[i].squares.size(), fine[i].squares.size()); ++k)
            worst.ofSquare = std::max(worst.ofSquare, steps[i].squares[k] - fine[i].squares[k]);
    }
    return worst;
}

std::ostream& operator<<(std::ostream& stream, const Excess& excess)
{
    return stream << "worst excess " << excess.ofMean << ", of a square " << excess.ofSquare;
}

/// Paints a grey square into a picture, as a sign that is shown too late.
void paintSquare(osg::Image& image, int left, int bottom, int sidePx)
{
    for (int y = bottom; y < bottom + sidePx; ++y)
        for (int x = left; x < left + sidePx; ++x)
            std::fill_n(image.data(x, y), image.getPixelSizeInBits() / 8, static_cast<unsigned char>(0x20));
}

TEST(RoadFrames, DifferNoMoreThanThoseOfAFineRender)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, "openscenario/esmini/xodr/curves_elevation.xodr");
    const Workplace place;
    const Shot shot{"curves", file, "driver", "160x90", 5};
    auto frames = framesOf(place, shot, "1");
    const std::vector<Difference> fine = stepsOf(framesOf(place, shot, "0.1"));
    const Excess excess = worstExcess(stepsOf(frames), fine);
    EXPECT_TRUE(excess.isAllowed()) << excess;
    // The mutations: a thing of 8 pixels that appears, which the mean alone does not see, and a frame of another moment.
    auto appearing = frames;
    appearing[2] = new osg::Image(*frames[2], osg::CopyOp::DEEP_COPY_ALL);
    paintSquare(*appearing[2], 81, 61, 8);
    const Excess ofThing = worstExcess(stepsOf(appearing), fine);
    EXPECT_GT(ofThing.ofSquare, kMostLevelsOfSquare);
    EXPECT_LE(ofThing.ofMean, kMostLevels);
    std::swap(frames[1], frames[4]);
    EXPECT_GT(worstExcess(stepsOf(frames), fine).ofMean, kMostLevels);
}

TEST(RoadFrames, OfTenNetworksFromTwoEyesDifferNoMore)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(folder, "openscenario/esmini/xodr");
    if (!std::getenv("OSGTRAINER_EVERY_FRAME")) GTEST_SKIP() << "takes minutes: set OSGTRAINER_EVERY_FRAME";
    const Workplace place;
    for (const char* name :
         {"e6mini", "fabriksgatan", "multi_intersections", "soderleden", "curves_elevation", "crest-curve",
          "tunnels", "velodrome", "straight_500m_signs", "two_plus_one"})
        for (const char* eye : {"driver", "above"})
        {
            const Shot shot{name, folder / (std::string(name) + ".xodr"), eye};
            const auto steps = stepsOf(framesOf(place, shot, "1")),
                       fine = stepsOf(framesOf(place, shot, "0.1"));
            const Excess excess = worstExcess(steps, fine);
            std::cout << name << ' ' << eye << ": mean " << meanOf(steps) << ", fine " << meanOf(fine) << ", "
                      << excess << '\n';
            EXPECT_TRUE(excess.isAllowed()) << name << ' ' << eye;
        }
}

} // namespace
