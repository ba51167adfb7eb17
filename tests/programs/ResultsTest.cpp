// SPDX-License-Identifier: Apache-2.0
// What a play leaves: pictures, figures, a report.
#include <algorithm>

#include "Playing.h"

namespace
{

using Keys = std::vector<std::string>;

class Results : public testing::Test
{
protected:
    Results() { _place.write("drive.xosc", driveText("hill.tif")); }

    Playing play(const std::string& name, const std::vector<std::string>& more = {}) const
    {
        return playedAs(_place, name, {"play", _place.path("drive.xosc")}, more);
    }

    /// Plays to the scenario's own end, a quarter of a second.
    void playToTheEnd(const std::string& name, const std::vector<std::string>& more = {}) const
    {
        std::vector<std::string> arguments{"play",      _place.path("drive.xosc"), "--size", "64x36",
                                           "--capture", _place.path(name)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        EXPECT_TRUE(succeeds(runTrainer(arguments)));
    }

    Workplace _place;
};

TEST_F(Results, PicturesAreNumberedAndOfTheSizeAskedFor)
{
    const Playing playing = play("frames", {"--size", "112x63", "--frames", "3"});
    Keys names;
    for (const auto& [name, bytes] : playing.frames)
        names.push_back(name);
    EXPECT_EQ(names, (Keys{"frame_00000.png", "frame_00001.png", "frame_00002.png"}));
    for (const std::string& name : names)
    {
        const PictureFacts facts = factsOf(_place.path("frames/" + name));
        EXPECT_EQ(facts.widthPx, 112);
        EXPECT_EQ(facts.heightPx, 63);
        EXPECT_GT(facts.colours, 100U) << name;
    }
}

TEST_F(Results, WithoutFramesTheScenarioEndsByItself)
{
    playToTheEnd("at24");
    EXPECT_EQ(bytesIn(_place.path("at24")).size(), 6U);
    playToTheEnd("at48", {"--fps", "48"});
    EXPECT_EQ(bytesIn(_place.path("at48")).size(), 12U);
}

TEST_F(Results, StatisticsHaveTheKeysThatWereAgreed)
{
    play("frames", {"--fps", "10", "--frames", "3"});
    const auto root = nlohmann::ordered_json::parse(readBytes(_place.path("frames.json")));
    EXPECT_EQ(keysOf(root), (Keys{"frames", "summary", "opening"}));
    ASSERT_FALSE(root["opening"].empty());
    EXPECT_EQ(root["opening"].back()["stage"], "first picture");
    EXPECT_GT(root["opening"].back()["processorS"], 0.0);
    ASSERT_EQ(root["frames"].size(), 3U);
    const Keys columns{"triangles",  "splits", "merges",      "adaptUs",     "cullMs",    "drawMs",
                       "maxErrorPx", "wallMs", "processorMs", "uploadBytes", "residentMb"};
    Keys row{"frame", "timeS"};
    row.insert(row.end(), columns.begin(), columns.end());
    for (std::size_t i = 0; i < 3; ++i)
    {
        const auto& frame = root["frames"][i];
        EXPECT_EQ(keysOf(frame), row);
        EXPECT_EQ(frame["frame"], i);
        EXPECT_NEAR(frame["timeS"].get<double>(), 0.1 * static_cast<double>(i), 1e-12);
        EXPECT_GT(frame["triangles"], 2);
        EXPECT_GT(frame["drawMs"], 0.0);
        EXPECT_EQ(frame["maxErrorPx"], 1.0); // the target, where the ceiling is far
    }
    EXPECT_GT(root["frames"][0]["splits"], 0);
    Keys summary{"frames"};
    summary.insert(summary.end(), columns.begin(), columns.end());
    EXPECT_EQ(keysOf(root["summary"]), summary);
}

TEST_F(Results, TheErrorTargetAndTheCeilingAreKept)
{
    const auto largest = [](const Playing& playing, const char* column)
    { return playing.statistics.at("summary").at(column).at("max").get<double>(); };
    const Playing fine = play("fine");
    const Playing coarse = play("coarse", {"--tolerance", "8"});
    EXPECT_LT(largest(coarse, "triangles"), largest(fine, "triangles"));
    EXPECT_EQ(largest(coarse, "maxErrorPx"), 8.0);
    const Playing few = play("few", {"--max-triangles", "300"});
    EXPECT_LE(largest(few, "triangles"), 300.0);
    EXPECT_GT(largest(few, "maxErrorPx"), 1.0) << "the tolerance reached is not reported";
}

/// What the operations of a frame cost by the model of viewlod/Slice.h, at least.
double modelledUs(const nlohmann::json& frame)
{
    return 0.07 * (frame.at("splits").get<double>() + frame.at("merges").get<double>());
}

TEST_F(Results, AdaptingKeepsItsTimeAndTheBoundMeanwhileIsTold)
{
    const std::vector<std::string> still{"--fps", "240", "--frames", "40", "--tolerance", "0.2"};
    const auto sliced = [&](const std::string& name)
    {
        std::vector<std::string> more = still;
        more.insert(more.end(), {"--adapt-time", "20"});
        return play(name, more);
    };
    const Playing whole = play("whole", still), one = sliced("one"), again = sliced("again");
    EXPECT_EQ(one.frames, again.frames) << "the cost model counts, not a clock";
    EXPECT_EQ(withoutMeasured(one.statistics), withoutMeasured(again.statistics));
    EXPECT_GT(modelledUs(whole.statistics["frames"][0]), 3 * 20.0) << "the control";
    for (const auto& frame : one.statistics["frames"])
        EXPECT_LE(modelledUs(frame), 20.0 + 5.0) << frame["frame"] << ": a forced chain may be begun last";
    const auto bound = [&](std::size_t i)
    {
        const auto& px = one.statistics["frames"][i]["maxErrorPx"]; // null: none is known yet
        return px.is_null() ? 1e9 : px.get<double>();
    };
    EXPECT_GT(bound(0), 0.2) << "what is left over must be told";
    EXPECT_EQ(bound(39), 0.2) << "the next frames do the rest";
    EXPECT_EQ(one.statistics["frames"][39]["triangles"], whole.statistics["frames"][39]["triangles"]);
    EXPECT_NE(one.frames.at("frame_00000.png"), whole.frames.at("frame_00000.png"));
}

TEST_F(Results, TheTimeOfAdaptingIsATerrainsOwnToo)
{
    _place.write("slow.roam", "dem = hill.tif\nadapt_time_us = 20\n");
    const std::vector<std::string> more{"--terrain", _place.path("slow.roam"), "--tolerance", "0.2"};
    EXPECT_LE(modelledUs(play("own", more).statistics["frames"][0]), 25.0);
    std::vector<std::string> longer = more;
    longer.insert(longer.end(), {"--adapt-time", "100000"});
    EXPECT_GT(modelledUs(play("longer", longer).statistics["frames"][0]), 60.0) << "the option goes before";
    const ProgramRun run = runTrainer({"play", _place.path("drive.xosc"), "--adapt-time", "20", "--method",
                                       "vipm-overlapping", "--capture", _place.path("none")});
    EXPECT_TRUE(failsWith(run, 1, "trainer", {"vipm-overlapping", "keeps no limit of time"}));
}

TEST_F(Results, PatchesAreDrawnAndCounted)
{
    const auto triangles = [](const Playing& playing)
    { return playing.statistics.at("summary").at("triangles").at("max").get<double>(); };
    const Playing plain = play("plain");
    const Playing patched = play("patched", {"--patch-exponent", "4"});
    EXPECT_GE(triangles(patched), triangles(plain));
    EXPECT_EQ(std::fmod(triangles(patched), 16.0), 0.0);
    EXPECT_EQ(patched.statistics.at("summary").at("maxErrorPx").at("max"), 1.0);
}

TEST_F(Results, TheFastestPatchesAreFoundByMeasuring)
{
    const ProgramRun run = runTrainer({"play", _place.path("drive.xosc"), "--size", "64x36", "--frames", "2",
                                       "--patch-exponent", "measure", "--capture", _place.path("measured")});
    ASSERT_TRUE(succeeds(run));
    EXPECT_NE(run.output.find("draws fastest here (0: "), std::string::npos) << run.output;
    std::size_t pictures = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(_place.path("measured")))
        ++pictures;
    EXPECT_EQ(pictures, 2u) << "what was drawn to measure is no picture of the play";
}

TEST_F(Results, TheReportShowsThePlots)
{
    const std::string file = _place.path("report.html");
    play("frames", {"--report", file, "--report-sheet", "sheet & all.png", "--report-video", "drive.mp4"});
    const std::string html = readBytes(file);
    EXPECT_TRUE(html.starts_with("<!doctype html>"));
    EXPECT_TRUE(html.ends_with("</html>\n"));
    for (const char* part :
         {"aria-label=\"Triangles drawn\"", "aria-label=\"Changes per frame\"", "aria-label=\"Adaptation",
          "aria-label=\"Error bound, pixels\"", "aria-label=\"Cull and draw, ms\"", "<polyline", "drive.xosc",
          "96 x 54", "src=\"sheet &amp; all.png\"", "src=\"drive.mp4\""})
        EXPECT_NE(html.find(part), std::string::npos) << part;
}

TEST_F(Results, ATourNamesItsTerrainInTheReport)
{
    playedAs(_place, "tour", {"tour", _place.hill()}, {"--report", _place.path("tour.html")});
    EXPECT_NE(readBytes(_place.path("tour.html")).find("<td>hill.tif</td>"), std::string::npos);
}

TEST_F(Results, NothingIsLeftThatWasNotAskedFor)
{
    const auto before = _place.files();
    EXPECT_TRUE(
        succeeds(runTrainer({"play", _place.path("drive.xosc"), "--size", "64x36", "--frames", "2"})));
    EXPECT_EQ(_place.files(), before);
    play("frames", {"--frames", "1"});
    auto after = before;
    after.insert(after.end(), {"frames", "frames.json", "frames/frame_00000.png"});
    std::sort(after.begin(), after.end());
    EXPECT_EQ(_place.files(), after);
}

} // namespace
