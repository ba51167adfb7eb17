// SPDX-License-Identifier: Apache-2.0
// A simulated hand presses the keys of a person in a window on a display of its own (Xvfb): a whole circuit
// with its landing, and a lap of a closed course. What was recorded repeats without a window to the same
// states and the same pictures.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include <osg/Image>
#include <osgDB/ReadFile>

#include "Playing.h"
#include "WindowRun.h"

namespace
{

class ByKeys : public testing::Test
{
protected:
    void SetUp() override
    {
        if (!hasXvfb()) GTEST_SKIP() << "SKIPPED: no Xvfb; install the package xvfb";
    }

    std::string path(const std::string& name) const { return place.path(name); }

    /// Rides in a window with ten pictures a second, and again by the recorded inputs, without pictures and
    /// with them.
    void rideAndRepeat(const std::vector<std::string>& ride, const std::string& eye, int pictures);

    Workplace place;
    ProgramRun window;
};

/// Columns of a table of motion. Units: s, m, m/s.
struct Row
{
    double timeS, x, y, z, speedMps;
};

std::vector<Row> rowsOf(const std::string& file)
{
    std::vector<Row> rows;
    std::istringstream lines(allOf(file));
    for (std::string line; std::getline(lines, line);)
    {
        std::vector<double> cells;
        std::istringstream words(line);
        for (std::string cell; std::getline(words, cell, ',');)
            cells.push_back(std::atof(cell.c_str()));
        if (cells.size() > 20 && std::isdigit(static_cast<unsigned char>(line[0])))
            rows.push_back({cells[1], cells[13], cells[14], cells[15], cells[4]});
    }
    return rows;
}

/// The share of bytes that differ. 1: pictures of other sizes, or none.
double differenceOf(const std::string& a, const std::string& b)
{
    const osg::ref_ptr<osg::Image> first = osgDB::readRefImageFile(a), second = osgDB::readRefImageFile(b);
    if (!first || !second || first->getTotalSizeInBytes() != second->getTotalSizeInBytes()) return 1.0;
    const unsigned bytes = first->getTotalSizeInBytes();
    unsigned others = 0;
    for (unsigned i = 0; i < bytes; ++i)
        others += first->data()[i] != second->data()[i] ? 1 : 0;
    return static_cast<double>(others) / bytes;
}

std::string frame(const std::string& folder, int number)
{
    char name[40];
    std::snprintf(name, sizeof name, "/frame_%05d.png", number);
    return folder + name;
}

void ByKeys::rideAndRepeat(const std::vector<std::string>& ride, const std::string& eye, int pictures)
{
    const std::vector<std::string> drawn{"--size", "64x36", "--samples", "1",   "--shadows", "off",
                                         "--eye",  eye,     "--quality", "low", "--capture"};
    window = runProgram(
        with(with({kOnDisplay, "--", OSGTRAINER_TRAINER}, withoutWorld(ride)),
             with(drawn, {path("seen"), "--mute", "--by-keys", "--picture-time", "0.1", "--csv_logger",
                          path("hand.csv"), "--record-inputs", path("hand.txt"), "--window"})),
        500.0);
    ASSERT_TRUE(succeeds(window));
    ASSERT_TRUE(succeeds(runTrainer(
        with(ride, {"--headless", "--inputs", path("hand.txt"), "--csv_logger", path("again.csv")}))));
    EXPECT_TRUE(allOf(path("hand.csv")) == allOf(path("again.csv"))) << "other states";
    ASSERT_TRUE(
        succeeds(runTrainer(with(ride, with(drawn, {path("replay"), "--inputs", path("hand.txt"), "--fps",
                                                    "10", "--frames", std::to_string(pictures)})))));
    // Over the first two a window may say how a parked car drives off.
    int others = 0;
    for (int i = 2; i < pictures; ++i)
        others += allOf(frame(path("seen"), i)) == allOf(frame(path("replay"), i)) ? 0 : 1;
    EXPECT_EQ(others, 0) << "of " << pictures << " pictures";
    // The control: the picture of half a second later.
    EXPECT_GT(differenceOf(frame(path("seen"), pictures / 2), frame(path("replay"), pictures / 2 + 5)), 0.1);
}

TEST_F(ByKeys, ACircuitWithItsLandingRepeats)
{
    rideAndRepeat({"fly", "--aircraft", kSeatAircraft, "--strip", "0,0,0,800"}, "pilot", 2700);
    const std::vector<Row> rows = rowsOf(path("hand.csv"));
    ASSERT_GT(rows.size(), 1000U);
    const auto highest =
        std::max_element(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.z < b.z; });
    const auto west =
        std::min_element(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.x < b.x; });
    EXPECT_GT(highest->z - rows.front().z, 200.0);
    EXPECT_LT(west->x, -800.0) << "no circuit";
    EXPECT_GT(highest->timeS, 60.0);
    // It stands on the strip, within its width.
    EXPECT_LT(std::abs(rows.back().speedMps), 0.1);
    EXPECT_LT(std::abs(rows.back().z - rows.front().z), 0.1);
    EXPECT_LT(std::abs(rows.back().x), 5.0);
    EXPECT_GT(rows.back().y, 0.0);
    EXPECT_LT(rows.back().y, 800.0);
}

/// Two straights of 150 m and two bends of 50 m, as two roads that follow each other.
std::string oval()
{
    const auto half = [](const char* id, const char* other, const char* begin, const char* bend)
    {
        const std::string link =
            std::string("elementType=\"road\" elementId=\"") + other + "\" contactPoint=";
        return std::string("<road id=\"") + id +
               "\" length=\"307.0796326794897\" junction=\"-1\"><link><predecessor " + link +
               "\"end\"/><successor " + link + "\"start\"/></link><planView><geometry s=\"0\" " + begin +
               " length=\"150\"><line/></geometry><geometry s=\"150\" " + bend +
               " length=\"157.0796326794897\"><arc curvature=\"0.02\"/></geometry></planView>"
               "<lanes><laneSection s=\"0\"><center><lane id=\"0\" type=\"none\"/></center><right>"
               "<lane id=\"-1\" type=\"driving\"><link><predecessor id=\"-1\"/><successor id=\"-1\"/></link>"
               "<width sOffset=\"0\" a=\"3.5\" b=\"0\" c=\"0\" "
               "d=\"0\"/></lane></right></laneSection></lanes></road>";
    };
    return "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/>" +
           half("1", "2", "x=\"0\" y=\"0\" hdg=\"0\"", "x=\"150\" y=\"0\" hdg=\"0\"") +
           half("2", "1", "x=\"150\" y=\"100\" hdg=\"3.141592653589793\"",
                "x=\"0\" y=\"100\" hdg=\"3.141592653589793\"") +
           "</OpenDRIVE>";
}

/// How far the words of the program say it was from the middle of its lane at most, in metres.
double worstM(const ProgramRun& run)
{
    const std::size_t at = run.output.find(" m from the middle");
    const std::size_t from = at == std::string::npos ? at : run.output.rfind(' ', at - 1);
    return from == std::string::npos ? 1e9 : std::atof(run.output.c_str() + from);
}

TEST_F(ByKeys, ALapRepeats)
{
    const std::string course = place.write("oval.xodr", oval());
    rideAndRepeat({"drive", course, "--vehicle", kSeatCar, "--length", "760"}, "driver", 500);
    const std::vector<Row> rows = rowsOf(path("hand.csv"));
    ASSERT_GT(rows.size(), 1000U);
    double drivenM = 0.0, backM = 1e9;
    for (std::size_t i = 1; i < rows.size(); ++i)
    {
        drivenM += std::hypot(rows[i].x - rows[i - 1].x, rows[i].y - rows[i - 1].y);
        if (drivenM > 500.0)
            backM = std::min(backM, std::hypot(rows[i].x - rows[0].x, rows[i].y - rows[0].y));
    }
    EXPECT_GT(drivenM, 614.0);
    EXPECT_LT(backM, 0.5) << "it did not come round";
    EXPECT_LT(worstM(window), 0.5) << window.output;
}

TEST_F(ByKeys, ALapOfTheDefaultCourseStaysInItsLane)
{
    if (!std::getenv("OSGTRAINER_EVERY_FRAME")) GTEST_SKIP() << "takes minutes: set OSGTRAINER_EVERY_FRAME";
    const std::string world = OSGTRAINER_DEFAULT_WORLD;
    rideAndRepeat({"drive", world, "--vehicle", kSeatCar, "--length", "7000", "--tolerance", "8"}, "driver",
                  600);
    EXPECT_LT(worstM(window), 0.5) << window.output;
}

} // namespace
