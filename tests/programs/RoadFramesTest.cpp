// SPDX-License-Identifier: Apache-2.0
// Consecutive frames of drives differ by no more than those of a render at a tenth of the error target, and
// one level, and in no square of 10 pixels by much more: nothing pops or shimmers that a finer mesh would not
// show. OSGTRAINER_EVERY_FRAME=1 draws 24 frames of ten networks from two eyes, which takes a quarter of an
// hour, and prints a table.
#include <cstdlib>
#include <iostream>

#include "FrameSteps.h"
#include "Playing.h"
#include "RealData.h"

namespace
{

/// Where a drive is looked at.
struct Shot
{
    std::string name;
    std::filesystem::path network;
    std::string eye = "driver";
    std::string size = "480x270";
    int frames = 24;
};

Frames framesOf(const Workplace& place, const Shot& shot, const std::string& tolerance)
{
    const std::string folder = shot.name + shot.eye + tolerance;
    playedAs(place, folder, {"tour", shot.network.string()},
             {"--eye", shot.eye, "--interior", "off", "--duration", "8", "--tolerance", tolerance, "--size",
              shot.size, "--frames", std::to_string(shot.frames)});
    Frames images = framesIn(place.path(folder));
    EXPECT_EQ(images.size(), static_cast<std::size_t>(shot.frames));
    return images;
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
    // The mutations: a thing of 8 pixels that appears, which the mean alone does not see, and a frame of
    // another moment.
    auto appearing = frames;
    appearing[2] = withSquare(*frames[2], 81, 61, 8);
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
