// SPDX-License-Identifier: Apache-2.0
// Rides by hand in a window, on a display of their own (Xvfb): what keys do, that it repeats without a
// window, and that nothing that happens to a window hangs or loses a recording.
#include <cstdio>

#include "Playing.h"
#include "WindowRun.h"

namespace
{

class Window : public testing::Test
{
protected:
    void SetUp() override
    {
        if (!hasXvfb()) GTEST_SKIP() << "SKIPPED: no Xvfb; install the package xvfb";
    }

    std::string keys(const std::string& name, const std::string& lines)
    {
        return place.write(name, "osgtrainer-keys 1\n" + lines);
    }

    std::string path(const std::string& name) { return place.path(name); }

    Workplace place;
};

TEST_F(Window, AFlightByKeysRepeatsHeadlessToTheLastByte)
{
    const std::vector<std::string> flight{"fly", "--aircraft", kSeatAircraft, "--start", "0,0,300,90,50"};
    const auto flown = [&](const std::string& name, const std::string& lines, const std::string& pictureS)
    {
        EXPECT_TRUE(succeeds(inWindow(
            with(flight, {"--keys", keys(name + ".keys", lines), "--picture-time", pictureS, "--csv_logger",
                          path(name + ".csv"), "--record-inputs", path(name + ".txt")}))));
        return allOf(path(name + ".csv"));
    };
    // A key counts from the first step of its picture on: these have the same one at both rates.
    const std::string lines =
        "0.51 hold Left 1\n1.01 hold PageUp 1\n2.01 tap f\n2.51 hold Down 0.5\n4 close\n";
    const std::string first = flown("first", lines, "0.1"), slow = flown("slow", lines, "0.5");
    EXPECT_GT(slow.size(), 40'000U);
    EXPECT_TRUE(first == slow) << "pictures of 500 ms change the flight";
    // The control: other keys.
    EXPECT_NE(slow, flown("other", "0.51 hold Right 1\n4 close\n", "0.5"));
    EXPECT_TRUE(succeeds(runTrainer(
        with(flight, {"--headless", "--inputs", path("first.txt"), "--csv_logger", path("again.csv")}))));
    EXPECT_EQ(first, allOf(path("again.csv")));
}

TEST_F(Window, ADriveIsTakenOverGivenBackAndRepeats)
{
    const std::vector<std::string> drive{"drive", kSeatStreet, "--vehicle", kSeatCar, "--length", "150"};
    const std::string lines = "1 tap Tab\n2 tap F2\n5 tap Tab\n5.5 hold Up 1.5\n6 hold Left 0.2\n8 close\n";
    const ProgramRun run =
        inWindow(with(drive, {"--keys", keys("drive.keys", lines), "--picture-time", "0.25", "--csv_logger",
                              path("hand.csv"), "--record-inputs", path("hand.txt")}));
    EXPECT_TRUE(succeeds(run));
    EXPECT_NE(run.output.find("s by hand"), std::string::npos) << run.text();
    EXPECT_TRUE(succeeds(runTrainer(
        with(drive, {"--headless", "--inputs", path("hand.txt"), "--csv_logger", path("again.csv")}))));
    const std::string hand = allOf(path("hand.csv"));
    EXPECT_GT(hand.size(), 40'000U);
    EXPECT_EQ(hand, allOf(path("again.csv")));
}

/// The clock of the machine: closed 20 s after it opened, it has shown 20 s, whatever a picture takes.
TEST_F(Window, RealTimeIsKeptWithPicturesOfHalfASecond)
{
    const std::vector<std::string> command{kOnDisplay, "--", "env",
                                           std::string("LD_PRELOAD=") + OSGTRAINER_SLOW_SWAP};
    std::vector<std::string> words = command;
    words.insert(words.end(),
                 {OSGTRAINER_TRAINER, "fly",           "--no-world",  "--aircraft",
                  kSeatAircraft,      "--mute",        "--interior",  "off",
                  "--shadows",        "off",           "--tolerance", "8",
                  "--start",          "0,0,300,90,50", "--keys",      keys("slow.keys", "20 close\n"),
                  "--size",           "64x36",         "--samples",   "1",
                  "--window"});
    const ProgramRun run = runProgram(words, 120.0);
    ASSERT_TRUE(succeeds(run));
    double shownS = 0.0, clockS = 0.0, meanMs = 0.0;
    int pictures = 0;
    const std::size_t line = run.output.find("shown ");
    ASSERT_NE(line, std::string::npos) << run.text();
    ASSERT_EQ(std::sscanf(run.output.c_str() + line,
                          "shown %lf s in %lf s of the clock, %d pictures of %lf ms", &shownS, &clockS,
                          &pictures, &meanMs),
              4);
    // The first picture compiles shaders. What a picture takes beyond a second is not caught up but told.
    double cutS = 0.0;
    if (const std::size_t note = run.output.find("note: "); note != std::string::npos)
        std::sscanf(run.output.c_str() + note, "note: %lf s were lost", &cutS);
    EXPECT_LT(cutS, 5.0);
    EXPECT_GT(meanMs, 500.0) << "pictures were quick: the test shows nothing";
    EXPECT_NEAR((shownS + cutS) / clockS, 1.0, 0.01);
    // The window closes in the picture after its time; that one shows it still.
    EXPECT_GT(shownS + cutS, 19.8 - 1.5e-3 * meanMs);
    EXPECT_LT(shownS + cutS, 20.2 + 1.5e-3 * meanMs);
}

TEST_F(Window, AKeyIsInThePictureOfItsFrame)
{
    const auto pictures = [&](const std::string& name, const std::string& lines)
    {
        EXPECT_TRUE(succeeds(inWindow(
            {"fly", place.hill(), "--aircraft", kSeatAircraft, "--start", "0,0,300,90,50", "--eye", "chase",
             "--keys", keys(name + ".keys", lines), "--picture-time", "0.1", "--capture", path(name)})));
        return bytesIn(path(name));
    };
    const auto without = pictures("without", "2 tap Escape\n"),
               keyed = pictures("keyed", "1 press Left\n2 tap Escape\n");
    ASSERT_EQ(without.size(), keyed.size());
    ASSERT_GE(keyed.size(), 20U);
    int number = 0, first = -1;
    for (const auto& [file, bytes] : keyed)
    {
        if (first < 0 && without.at(file) != bytes) first = number;
        ++number;
    }
    // Pressed at 1.0 s: picture 10.
    EXPECT_GE(first, 10);
    EXPECT_LE(first, 12) << "more than two pictures behind";
    RecordProperty("picturesBehind", first - 10);
}

TEST_F(Window, BinocularsShowMoreWhileTheirKeyIsHeld)
{
    const auto pictures = [&](const std::string& name, const std::string& lines)
    {
        EXPECT_TRUE(
            succeeds(inWindow({"fly", place.hill(), "--aircraft", kSeatAircraft, "--start", "0,0,300,90,50",
                               "--interior", "off", "--keys", keys(name + ".keys", lines), "--picture-time",
                               "0.1", "--capture", path(name)})));
        return bytesIn(path(name));
    };
    const auto plain = pictures("plain", "2 tap Escape\n"),
               held = pictures("held", "0.8 press r\n1.2 release r\n2 tap Escape\n");
    ASSERT_EQ(plain.size(), held.size());
    ASSERT_GE(held.size(), 20U);
    int number = 0, others = 0;
    for (const auto& [file, bytes] : held)
    {
        const bool isSame = plain.at(file) == bytes;
        others += isSame ? 0 : 1;
        EXPECT_TRUE(isSame || (number >= 8 && number <= 14)) << file;
        ++number;
    }
    EXPECT_GE(others, 3);
    EXPECT_LE(others, 6) << "the hand moves nothing else";
}

TEST_F(Window, ResetKeepsWhatWasRecorded)
{
    const std::string lines = "1 tap BackSpace\n2 tap Home\n3 tap p\n3.2 tap Period\n4 close\n";
    const ProgramRun run = inWindow({"fly", "--aircraft", kSeatAircraft, "--strip", "0,0,0,800", "--keys",
                                     keys("reset.keys", lines), "--picture-time", "0.1", "--record-inputs",
                                     path("in.txt"), "--csv_logger", path("in.csv")});
    EXPECT_TRUE(succeeds(run));
    for (const char* name : {"in.txt", "in-1.txt", "in-2.txt", "in.csv", "in-1.csv", "in-2.csv"})
        EXPECT_GT(allOf(path(name)).size(), 100U) << name;
    EXPECT_NE(run.output.find("--start "), std::string::npos) << run.text();
}

TEST_F(Window, ResizedAndClosedAtAnyMomentItLosesNothing)
{
    for (const char* lines :
         {"0 close\n", "0.1 resize 300 40\n0.2 resize 16 200\n0.3 tap F1\n0.4 tap F11\n0.5 close\n",
          "0.1 tap v\n0.2 tap v\n0.3 tap v\n0.4 tap v\n0.5 tap v\n0.6 tap v\n0.7 tap Escape\n"})
    {
        const std::string recorded = path("closed.txt");
        std::filesystem::remove(recorded);
        EXPECT_TRUE(
            succeeds(inWindow({"fly", "--aircraft", kSeatAircraft, "--keys", keys("close.keys", lines),
                               "--picture-time", "0.1", "--record-inputs", recorded})))
            << lines;
        EXPECT_EQ(std::filesystem::exists(recorded), std::string(lines).find("0 close") != 0) << lines;
    }
}

TEST_F(Window, ASignalEndsItWithItsRecording)
{
    const std::string recorded = path("ended.txt"), shown = path("picture-1.png");
    const std::string line = std::string(OSGTRAINER_TRAINER) + " fly --no-world --aircraft " + kSeatAircraft +
                             " --keys " + keys("end.keys", "0.5 tap F12\n") + " --pictures " + path("") +
                             " --record-inputs " + recorded +
                             " --size 96x54 --samples 1 --window & p=$!; while [ ! -e " + shown +
                             " ]; do sleep 0.1; done; kill -TERM $p; wait $p";
    EXPECT_TRUE(succeeds(runProgram({kOnDisplay, "--", "sh", "-c", line}, 60.0)));
    EXPECT_EQ(allOf(recorded).rfind("osgtrainer-inputs 1", 0), 0U);
}

/// The server of the display is killed, as when a session on a desktop ends.
TEST_F(Window, ADisplayThatGoesAwayLeavesTheRecording)
{
    const std::string recorded = path("gone.txt"), motion = path("gone.csv"), shown = path("picture-1.png");
    const std::string line = std::string(OSGTRAINER_TRAINER) + " fly --no-world --aircraft " + kSeatAircraft +
                             " --keys " + keys("gone.keys", "0.5 tap F12\n") + " --pictures " + path("") +
                             " --record-inputs " + recorded + " --csv_logger " + motion +
                             " --size 96x54 --samples 1 --mute --window & p=$!; while [ ! -e " + shown +
                             " ]; do sleep 0.1; done; pkill -KILL -P $PPID Xvfb; wait $p";
    const ProgramRun run = runProgram({kOnDisplay, "--", "sh", "-c", line}, 60.0);
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_NE(run.errors.find("trainer: --window: the display has gone away"), std::string::npos)
        << run.text();
    EXPECT_EQ(allOf(recorded).rfind("osgtrainer-inputs 1", 0), 0U);
    EXPECT_GT(allOf(motion).size(), 1000U);
    // What is recorded is whole: it can be played.
    EXPECT_TRUE(
        succeeds(runTrainer({"fly", "--aircraft", kSeatAircraft, "--headless", "--inputs", recorded})));
}

/// A tour and a scenario show in a window as well, on the whole screen too.
TEST_F(Window, ToursAndPlaysShowAndEnd)
{
    const std::string ends = keys("ends.keys", "0.3 tap v\n0.6 tap F1\n0.9 tap Tab\n1 close\n");
    EXPECT_TRUE(succeeds(inWindow({"tour", place.hill(), "--keys", ends, "--picture-time", "0.1"})));
    const std::string scenario = path("tour.xosc");
    ASSERT_TRUE(
        succeeds(runTrainer({"tour", place.hill(), "--save", scenario, "--frames", "1", "--size", "64x36"})));
    EXPECT_TRUE(succeeds(
        inWindow({"play", scenario, "--terrain", place.hill(), "--keys", ends, "--picture-time", "0.1"})));
    const ProgramRun full = inWindow({"tour", place.hill(), "--fullscreen", "--keys", ends, "--picture-time",
                                      "0.1", "--capture", path("full")});
    EXPECT_TRUE(succeeds(full));
    const auto pictures = bytesIn(path("full"));
    ASSERT_FALSE(pictures.empty());
    EXPECT_EQ(factsOf(std::filesystem::path(path("full")) / pictures.begin()->first).widthPx, 1280)
        << "not the whole screen";
}

/// Two on one display, each with its recording.
TEST_F(Window, ASecondInstanceDoesNotDisturbTheFirst)
{
    const auto one = [&](const std::string& name)
    {
        return std::string(OSGTRAINER_TRAINER) + " fly --no-world --aircraft " + kSeatAircraft + " --keys " +
               keys(name + ".keys", "1 close\n") + " --record-inputs " + path(name + ".txt") +
               " --picture-time 0.1 --size 96x54 --samples 1 --window";
    };
    EXPECT_TRUE(succeeds(
        runProgram({kOnDisplay, "--", "sh", "-c", one("a") + " & p=$!; " + one("b") + " && wait $p"}, 60.0)));
    EXPECT_EQ(allOf(path("a.txt")), allOf(path("b.txt")));
    EXPECT_GT(allOf(path("a.txt")).size(), 50U);
}

TEST_F(Window, SaysWhatADisplayLacks)
{
    EXPECT_TRUE(failsWith(inWindow({"fly", "--aircraft", kSeatAircraft}, {kOnDisplay, "-extension", "GLX"}),
                          1, "trainer", {"--window", "OpenGL"}));
    EXPECT_TRUE(failsWith(inWindow({"fly", "--aircraft", kSeatAircraft, "--screen", "7"}), 1, "trainer",
                          {"--screen", "screens"}));
    EXPECT_TRUE(failsWith(runProgram({"env", "-u", "DISPLAY", OSGTRAINER_TRAINER, "fly", "--no-world",
                                      "--aircraft", kSeatAircraft, "--window"}),
                          1, "trainer", {"--window", "DISPLAY"}));
    EXPECT_TRUE(
        failsWith(runTrainer({"fly", "--window", "1", "2", "3"}), 2, "trainer", {"--window", "3 values"}));
    EXPECT_TRUE(failsWith(runTrainer({"fly", "--window", "x.tif"}), 2, "trainer", {"--window", "x.tif"}));
}

} // namespace
