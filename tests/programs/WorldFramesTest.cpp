// SPDX-License-Identifier: Apache-2.0
// Consecutive frames of the default world differ by no more than those of `--quality reference` (a tenth of
// the error target, every tree with all faces that a pixel can show, shadow maps of four times the side) and
// one level: nothing pops, shimmers or crawls that a finer picture would not show. The default world is the
// target default_world; the test is skipped where that has not been built. OSGTRAINER_EVERY_FRAME=1 draws 24
// frames from six views, which takes twenty minutes of processor time, and prints a table;
// OSGTRAINER_FRAMES=FOLDER keeps the frames.
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <utility>

#include <nlohmann/json.hpp>

#include "FrameSteps.h"
#include "Playing.h"

namespace
{

namespace fs = std::filesystem;

constexpr double kLimitS = 3600.0; ///< of a play
const fs::path kWorld = OSGTRAINER_DEFAULT_WORLD_FOLDER;

/// What is looked at.
struct View
{
    const char* name;
    const char* scenario;
    std::vector<std::string> eye;
    const char* fromM = "550.0"; ///< where the car begins, along the road of the file
};

const std::vector<View> kViews{
    {"road", "drive.xosc", {"--eye", "driver", "--interior", "off"}},
    {"street", "drive.xosc", {"--eye", "driver", "--interior", "off"}, "900.0"},
    {"behind", "drive.xosc", {"--eye", "chase"}, "700.0"},
    {"above-15", "drive.xosc", {"--eye", "above", "--eye-height", "15"}},
    {"circuit", "circuit.xosc", {"--eye", "pilot", "--interior", "off", "--eye-entity", "aircraft"}},
    {"above-1500", "drive.xosc", {"--eye", "above", "--eye-height", "1500"}},
};

std::string textOf(const fs::path& file)
{
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// The scenario of a view, beside which nothing of the world lies.
std::string scenarioOf(const Workplace& place, const View& view)
{
    std::string text = textOf(kWorld / view.scenario);
    for (const char* file : {"roads.xodr", "world.roam"})
        text = with(text, '"' + std::string(file) + '"', '"' + (kWorld / file).string() + '"');
    text = with(text, "s=\"550.0\"", "s=\"" + std::string(view.fromM) + '"');
    return place.write(std::string(view.name) + ".xosc", text);
}

Frames framesOf(const Workplace& place, const View& view, const std::string& quality, const std::string& size,
                int count)
{
    const std::string name = std::string(view.name) + '-' + quality;
    std::vector<std::string> command{OSGTRAINER_TRAINER,
                                     "play",
                                     scenarioOf(place, view),
                                     "--capture",
                                     place.path(name),
                                     "--quality",
                                     quality,
                                     "--samples",
                                     "1",
                                     "--size",
                                     size,
                                     "--frames",
                                     std::to_string(count)};
    command.insert(command.end(), view.eye.begin(), view.eye.end());
    EXPECT_TRUE(succeeds(runProgram(command, kLimitS)));
    const Frames frames = framesIn(place.path(name));
    EXPECT_EQ(frames.size(), static_cast<std::size_t>(count));
    if (const char* const kept = std::getenv("OSGTRAINER_FRAMES"))
        fs::copy(place.path(name), fs::path(kept) / name,
                 fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    return frames;
}

/// In the root of the project for as long as it lives: `data/` there has the vehicles' files.
class InProject
{
public:
    InProject() { fs::current_path(OSGTRAINER_PROJECT); }
    ~InProject() { fs::current_path(_before); }
    InProject(const InProject&) = delete;
    InProject& operator=(const InProject&) = delete;

private:
    fs::path _before = fs::current_path();
};

bool isWorldMade()
{
    return fs::exists(kWorld / "world.roam");
}

TEST(WorldFrames, DifferNoMoreThanThoseOfTheReference)
{
    if (!isWorldMade()) GTEST_SKIP() << "build the target default_world";
    const InProject project;
    const Workplace place;
    Frames frames = framesOf(place, kViews.front(), "high", "160x90", 4);
    const auto fine = stepsOf(framesOf(place, kViews.front(), "reference", "160x90", 4));
    ASSERT_EQ(frames.size(), fine.size() + 1);
    const Excess excess = worstExcess(stepsOf(frames), fine);
    EXPECT_TRUE(excess.isAllowed()) << excess;
    // The mutations: a thing of 8 pixels that appears, and a frame of another moment.
    Frames appearing = frames;
    appearing[2] = withSquare(*frames[2], 81, 61, 8);
    EXPECT_GT(worstExcess(stepsOf(appearing), fine).ofSquare, kMostLevelsOfSquare);
    std::swap(frames[0], frames[2]);
    EXPECT_FALSE(worstExcess(stepsOf(frames), fine).isAllowed());
}

TEST(WorldFrames, OfSixViewsDifferNoMore)
{
    if (!isWorldMade()) GTEST_SKIP() << "build the target default_world";
    if (!std::getenv("OSGTRAINER_EVERY_FRAME")) GTEST_SKIP() << "takes minutes: set OSGTRAINER_EVERY_FRAME";
    const InProject project;
    const Workplace place;
    for (const View& view : kViews)
    {
        const auto steps = stepsOf(framesOf(place, view, "high", "480x270", 24)),
                   fine = stepsOf(framesOf(place, view, "reference", "480x270", 24));
        const Excess excess = worstExcess(steps, fine);
        std::cout << view.name << ": mean " << meanOf(steps) << ", reference " << meanOf(fine) << ", "
                  << excess << std::endl;
        EXPECT_LE(excess.ofMean, kMostLevels) << view.name;
    }
}

/// The draws of a picture, and of its shadow maps, by what was left out.
std::map<std::string, std::pair<double, double>> drawsByPart(const Workplace& place)
{
    const std::string file = place.path("parts.json");
    EXPECT_TRUE(succeeds(runProgram({OSGTRAINER_TRAINER, "play", scenarioOf(place, kViews.front()), "--eye",
                                     "driver", "--interior", "off", "--samples", "1", "--size", "320x180",
                                     "--frames", "40", "--parts", file},
                                    kLimitS)));
    std::map<std::string, std::pair<double, double>> draws;
    const auto table = nlohmann::json::parse(textOf(file));
    for (const auto& row : table.at("parts"))
        draws[row.at("without")] = {row.at("draws"), row.at("mapDraws")};
    return draws;
}

TEST(WorldDraws, FromTheDriversSeatAreAtMost400AndOfShadowMapsToo)
{
    if (!isWorldMade()) GTEST_SKIP() << "build the target default_world";
    const InProject project;
    const Workplace place;
    const auto draws = drawsByPart(place);
    for (const char* part : {"", "entities", "shadows"})
        ASSERT_TRUE(draws.contains(part)) << part;
    const auto [picture, maps] = draws.at("");
    EXPECT_LE(picture, 400.0);
    EXPECT_LE(maps, 400.0);
    RecordProperty("draws", std::to_string(picture) + ", of maps " + std::to_string(maps));
    // The figures count: without vehicles both are smaller, without shadows there are no maps.
    EXPECT_GT(picture, draws.at("entities").first + 20.0);
    EXPECT_GT(maps, draws.at("entities").second + 20.0);
    EXPECT_EQ(draws.at("shadows").second, 0.0);
}

} // namespace
