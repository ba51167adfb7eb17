// SPDX-License-Identifier: Apache-2.0
// What happens to a window on a desktop: a mouse, other windows, being minimised (unmapped, as a window
// manager does it), devices that are pulled. Events are those of the X server, by xdotool; the display is one
// of its own (Xvfb).
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "Playing.h"
#include "WindowRun.h"

namespace
{

class Desk : public testing::Test
{
protected:
    void SetUp() override
    {
        if (!hasXvfb() || std::system("command -v xdotool >/dev/null") != 0)
            GTEST_SKIP() << "SKIPPED: no desk; install the packages xvfb and xdotool";
    }

    /// Flies in a window of 240x136 while a shell does `actions`: $w is the window, shot N waits for its N-th
    /// picture, wanted by F12.
    /// Exit code: the trainer's.
    ProgramRun fly(const std::string& actions, const std::string& keys = "", const std::string& more = "",
                   const std::string& before = "")
    {
        const std::string script = place.write("desk.keys", "osgtrainer-keys 1\n" + keys + "0.6 tap F12\n");
        const std::string line =
            before + " " + OSGTRAINER_TRAINER + " fly --no-world --aircraft " + kSeatAircraft +
            " --mute --interior off --shadows off --quality low --tolerance 8 --keys " + script +
            " --pictures " + path("") + " --record-inputs " + path("in.txt") + " --csv_logger " +
            path("in.csv") + " --size 240x136 --samples 1 " + more +
            " --window & p=$!; shot() { n=0; while [ ! -s " + path("picture-") +
            "$1.png ] && [ $n -lt 2400 ]; do n=$((n+1)); sleep 0.1; done; sleep 0.3; }; "
            "shot 1; w=$(xdotool search --onlyvisible --name '^trainer$' | head -n 1); " +
            actions + "; wait $p";
        return runProgram({kOnDisplay, "--", "sh", "-c", line}, 400.0);
    }

    std::string path(const std::string& name) const { return place.path(name); }
    std::string picture(int number) const
    {
        return allOf(path("picture-" + std::to_string(number) + ".png"));
    }

    /// The values of an input in the recording, in the order of time.
    std::vector<double> recorded(const std::string& input) const
    {
        std::istringstream lines(allOf(path("in.txt")));
        std::vector<double> values;
        std::size_t column = 0;
        for (std::string line; std::getline(lines, line);)
        {
            std::istringstream words(line);
            std::vector<std::string> cells;
            for (std::string cell; words >> cell;)
                cells.push_back(cell);
            if (cells.empty()) continue;
            if (cells[0] == "columns")
                column =
                    static_cast<std::size_t>(std::find(cells.begin(), cells.end(), input) - cells.begin()) -
                    1;
            else if (std::isdigit(static_cast<unsigned char>(cells[0][0])) && column < cells.size())
                values.push_back(cells[column] == "-" && !values.empty() ? values.back()
                                                                         : std::atof(cells[column].c_str()));
        }
        return values;
    }

    /// Of the table of motion. Units: s.
    double lastRowS() const
    {
        const std::string table = allOf(path("in.csv"));
        const std::size_t line = table.rfind('\n', table.size() - 2);
        const std::size_t cell = table.find(',', line == std::string::npos ? 0 : line);
        return cell == std::string::npos ? 0.0 : std::atof(table.c_str() + cell + 1);
    }

    Workplace place;
};

TEST_F(Desk, AHeldMouseTurnsTheHeadAndAKeyPutsItBack)
{
    // A picture says where the last one was written for 4 s.
    const std::string shoot = "sleep 5; xdotool key F12; shot ";
    ASSERT_TRUE(
        succeeds(fly("xdotool windowfocus $w mousemove --window $w 120 70 mousedown 1 mousemove --window $w "
                     "180 60 mousemove --window $w 220 50 mouseup 1; " +
                         shoot + "2; xdotool mousemove --window $w 20 20; " + shoot + "3; xdotool key o; " +
                         shoot + "4; xdotool key Escape",
                     "0.3 tap p\n")));
    ASSERT_GT(picture(1).size(), 500U);
    EXPECT_TRUE(picture(1) != picture(2)) << "the mouse does nothing";
    EXPECT_TRUE(picture(2) == picture(3)) << "a mouse without a button turns the head";
    EXPECT_TRUE(picture(1) == picture(4)) << "not straight ahead again";
}

TEST_F(Desk, MinimisedItGoesOnAndComesBack)
{
    const ProgramRun run =
        fly("a=$(stat -c %s " + path("in.csv") +
            " 2>/dev/null || echo 0); xdotool windowunmap $w; sleep 2; xdotool search --onlyvisible --name "
            "'^trainer$' >" +
            path("seen") +
            "; xdotool windowmap $w; sleep 1; xdotool windowfocus $w; sleep 0.5; xdotool key F12; shot 2; "
            "xdotool key Escape");
    ASSERT_TRUE(succeeds(run));
    EXPECT_EQ(allOf(path("seen")), "") << "it was not minimised";
    EXPECT_GT(picture(2).size(), 500U) << "no picture after it";
    EXPECT_GT(lastRowS(), 2.5) << "time stood still";
    EXPECT_FALSE(recorded("elevator").empty());
}

TEST_F(Desk, LosingTheFocusLetsGoOfTheKeys)
{
    // Another window takes the keyboard while the key is down; it comes up there.
    ASSERT_TRUE(succeeds(fly("xdotool windowfocus $w; sleep 0.3; xdotool keydown Left; sleep 0.7; "
                             "r=$(xdotool search --maxdepth 0 --name '' 2>/dev/null | head -n 1); "
                             "xdotool windowfocus ${r:-1}; sleep 0.2; xdotool keyup Left; sleep 1.5; "
                             "xdotool windowfocus $w; sleep 0.3; xdotool key Escape")));
    const std::vector<double> aileron = recorded("aileron");
    ASSERT_FALSE(aileron.empty());
    EXPECT_LT(*std::min_element(aileron.begin(), aileron.end()), -0.05) << "the key did nothing";
    EXPECT_EQ(aileron.back(), 0.0) << "the key stays down";
}

TEST_F(Desk, DestroyedOrCutOffByOthersItKeepsItsRecording)
{
    for (const char* action : {"windowclose", "windowkill"})
    {
        std::filesystem::remove(path("in.txt"));
        std::filesystem::remove(path("picture-1.png"));
        const ProgramRun run = fly(std::string("xdotool ") + action + " $w");
        EXPECT_FALSE(run.timedOut) << action;
        EXPECT_EQ(run.exitCode, 1) << action << run.text();
        EXPECT_NE(run.text().find("what was recorded is written"), std::string::npos) << action << run.text();
        EXPECT_EQ(allOf(path("in.txt")).rfind("osgtrainer-inputs 1", 0), 0U) << action << run.text();
    }
}

/// At moments that nobody hits by hand: when a picture begins, and before and after it is shown. Mesa's
/// drawing without a GPU asks for the size of the window there, and faults in one of eight runs of a program
/// that goes on.
TEST_F(Desk, DestroyedWhileAPictureIsMadeItKeepsItsRecording)
{
    for (const char* moment : {"draw 12", "show 12", "shown 12"})
    {
        std::filesystem::remove(path("in.txt"));
        const std::string preloaded =
            std::string("LD_PRELOAD=") + OSGTRAINER_LOST_WINDOW + " OSGTRAINER_LOSE_WINDOW='" + moment + "'";
        const ProgramRun run = runProgram(
            {kOnDisplay, "--", "sh", "-c",
             preloaded + " exec " + OSGTRAINER_TRAINER + " fly --no-world --aircraft " + kSeatAircraft +
                 " --mute --interior off --shadows off --tolerance 8 --record-inputs " + path("in.txt") +
                 " --size 240x136 --samples 1 --window"},
            150.0);
        EXPECT_FALSE(run.timedOut) << moment;
        EXPECT_EQ(run.exitCode, 1) << moment << run.text();
        EXPECT_NE(run.text().find("another program has destroyed the window"), std::string::npos)
            << moment << run.text();
        EXPECT_EQ(allOf(path("in.txt")).rfind("osgtrainer-inputs 1", 0), 0U) << moment << run.text();
    }
}

TEST_F(Desk, ResizedByOthersAgainAndAgainItGoesOn)
{
    ASSERT_TRUE(succeeds(fly("for s in '300 20' '17 200' '640 360' '33 33' '800 16' '240 136'; do xdotool "
                             "windowsize $w $s; sleep 0.15; done; xdotool windowfocus $w; sleep 0.5; xdotool "
                             "key F12; shot 2; xdotool key Escape")));
    EXPECT_GT(picture(2).size(), 500U);
}

#ifdef OSGTRAINER_PULLED_STICK
/// A stick that a library puts into the program's SDL: it comes, moves, is pulled while a button is held, and
/// returns.
TEST_F(Desk, APulledDeviceIsToldAndTakenUpAgain)
{
    const std::string maps =
        place.write("devices.txt", "osgtrainer-devices 1\ndevice *\naxis 0 aileron\nbutton 0 PageDown\n");
    const ProgramRun run = fly("xdotool search --name '^trainer$' >/dev/null; sleep 6; xdotool windowfocus "
                               "$w; sleep 0.5; xdotool key Escape",
                               "", "--devices " + maps, std::string("LD_PRELOAD=") + OSGTRAINER_PULLED_STICK);
    ASSERT_TRUE(succeeds(run));
    const std::vector<double> aileron = recorded("aileron"), throttle = recorded("throttle");
    ASSERT_FALSE(aileron.empty());
    EXPECT_GT(*std::max_element(aileron.begin(), aileron.end()), 0.4) << "the first time";
    EXPECT_LT(*std::min_element(aileron.begin(), aileron.end()), -0.4) << "after it returned";
    EXPECT_GT(throttle.back(), 0.0) << "the button of a pulled stick stays down";
    EXPECT_LT(throttle.back(), throttle.front()) << "the button did nothing";
}
#endif

} // namespace
