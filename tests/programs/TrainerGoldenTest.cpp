// SPDX-License-Identifier: Apache-2.0
// Frames of the trainer itself, compared byte for byte: a flight, a drive at dusk with scenery, a drive
// through two channels, one in rain, a tour with scenery. Each is the last of some frames, so that speeds and
// clocks count. Written anew by OSGTRAINER_WRITE_GOLDEN=1 ctest -R TrainerGolden; tests/faults seeds faults
// that these frames must show.
#include <osgOffscreen/OffscreenContext>
#include <osgOffscreen/PngFile>

#include "KeptFiles.h"
#include "ProgramRun.h"
#include "RenderedGolden.h"
#include "Workplace.h"

namespace
{

using Arguments = std::vector<std::string>;

std::string rendererName()
{
    osgOffscreen::OffscreenSettings settings;
    settings.widthPx = settings.heightPx = 16;
    const auto context = osgOffscreen::OffscreenContext::create(settings);
    return context ? (*context)->rendererName() : "";
}

/// Compares a frame with its golden image.
testing::AssertionResult matches(const std::filesystem::path& frame, const std::string& golden)
{
    const auto image = osgOffscreen::readPng(frame);
    if (!image) return testing::AssertionFailure() << image.error().message();
    return rendered::matchesGolden(**image, golden, rendererName());
}

/// Runs the trainer for five frames and returns the folder of its frames.
std::filesystem::path captured(const Workplace& place, Arguments arguments)
{
    const std::string folder = place.path("frames");
    arguments.insert(arguments.end(), {"--frames", "5", "--capture", folder});
    EXPECT_TRUE(succeeds(runTrainer(arguments)));
    return folder;
}

std::string environment(const std::string& time, const std::string& clouds, int visibilityM)
{
    return "<GlobalAction><EnvironmentAction><Environment name=\"air\"><TimeOfDay animation=\"false\" "
           "dateTime=\"" +
           time + "\"/><Weather fractionalCloudCover=\"" + clouds + "\"><Fog visualRange=\"" +
           std::to_string(visibilityM) + "\"/></Weather></Environment></EnvironmentAction></GlobalAction>";
}

std::string timed(const std::string& position, int seconds)
{
    return simulation::vertex("<WorldPosition " + position + "/>", std::to_string(seconds));
}

std::string overHill(const simulation::ScenarioText& text)
{
    return with(text.text(), "<RoadNetwork/>",
                "<RoadNetwork><SceneGraphFile filepath=\"hill.tif\"/></RoadNetwork>");
}

/// An aircraft turns towards the hill, in the morning.
std::string flightText(const std::string& time = "2024-06-21T07:00:00Z")
{
    simulation::ScenarioText text;
    text.globals = environment(time, "twoOktas", 9000);
    text.privates = simulation::followTrajectory(
        timed("x=\"-600\" y=\"-500\" z=\"455\"", 0) + timed("x=\"-520\" y=\"-450\" z=\"458\"", 2) +
            timed("x=\"-450\" y=\"-380\" z=\"462\"", 4) + timed("x=\"-400\" y=\"-290\" z=\"466\"", 6),
        simulation::kTiming, "follow");
    text.stop = simulation::stopAt(6.0);
    return with(overHill(text), "vehicleCategory=\"car\"", "vehicleCategory=\"aircraft\"");
}

/// A cube with a painted side, for an entity with a model of its own.
void writeCrate(const Workplace& place)
{
    place.write("crate.obj", "mtllib crate.mtl\nusemtl paint\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
                             "v -1 -1 2\nv 1 -1 2\nv 1 1 2\nv -1 1 2\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                             "f 1/1 2/2 6/3 5/4\nf 2/1 3/2 7/3 6/4\nf 3/1 4/2 8/3 7/4\nf 4/1 1/2 5/3 8/4\n"
                             "f 5/1 6/2 7/3 8/4\n");
    place.write("crate.mtl", "newmtl paint\nKd 1 1 1\nmap_Kd crate.png\n");
    osg::ref_ptr<osg::Image> paint = new osg::Image;
    paint->allocateImage(8, 8, 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
        {
            unsigned char* const rgb = paint->data(static_cast<unsigned>(x), static_cast<unsigned>(y));
            rgb[0] = (x + y) % 2 == 0 ? 230 : 40;
            rgb[1] = static_cast<unsigned char>(30 * x);
            rgb[2] = 60;
        }
    EXPECT_TRUE(osgOffscreen::writePng(*paint, place.path("crate.png")));
}

/// A car steers to the left past a crate.
std::string pastCrateText(const std::string& time, const std::string& clouds)
{
    simulation::ScenarioText text;
    text.entities +=
        "<ScenarioObject name=\"Crate\"><MiscObject name=\"crate\" miscObjectCategory=\"obstacle\" "
        "model3d=\"crate.obj\"><BoundingBox><Center x=\"0\" y=\"0\" z=\"1\"/><Dimensions "
        "width=\"2\" length=\"2\" height=\"2\"/></BoundingBox><Properties/></MiscObject>"
        "</ScenarioObject>";
    text.globals = environment(time, clouds, 2500) + "<Private entityRef=\"Crate\">" +
                   simulation::teleport("<WorldPosition x=\"-562\" y=\"-96\" h=\"0.5\"/>") + "</Private>";
    text.privates =
        simulation::followTrajectory(timed("x=\"-600\" y=\"-100\"", 0) + timed("x=\"-588\" y=\"-99\"", 1) +
                                         timed("x=\"-577\" y=\"-95\"", 2) + timed("x=\"-568\" y=\"-88\"", 3) +
                                         timed("x=\"-562\" y=\"-78\"", 4),
                                     simulation::kTiming, "follow");
    text.stop = simulation::stopAt(4.0);
    return overHill(text);
}

/// A car on a wet road in rain and wind.
std::string rainText()
{
    simulation::ScenarioText text;
    text.globals =
        "<GlobalAction><EnvironmentAction><Environment name=\"rain\"><Weather><Precipitation "
        "precipitationType=\"rain\" precipitationIntensity=\"6\"/><Wind direction=\"1\" speed=\"5\"/>"
        "</Weather><RoadCondition frictionScaleFactor=\"1\" wetness=\"wetWithPuddles\"/>"
        "</Environment></EnvironmentAction></GlobalAction>";
    text.privates = simulation::teleport("<LanePosition roadId=\"1\" laneId=\"-1\" s=\"20\"/>") +
                    simulation::speedAction(15.0);
    text.stop = simulation::stopAt(4.0);
    return with(text.text(), "<RoadNetwork/>",
                "<RoadNetwork><LogicFile filepath=\"" OSGTRAINER_SOURCE_DIR
                "/data/scenarios/physics.xodr\"/></RoadNetwork>");
}

constexpr const char* kTwoChannels = R"(<View nearM="0.5">
<Channel name="left" widthPx="160" heightPx="120" yawDeg="-22" fovXDeg="44"/>
<Channel name="right" widthPx="160" heightPx="120" yawDeg="22" pitchDeg="-3" xM="0.5" yM="-1" zM="0.4">
<Frustum leftDeg="-22" rightDeg="30" bottomDeg="-20" topDeg="15"/></Channel></View>)";

/// Buildings, vehicles and foliage: every finish of the generated models, near enough to be seen.
constexpr const char* kRoadside = R"({"budget": {"triangles": 20000}, "fields": [
 {"name": "barns", "count": 20, "objects": [{"kind": "barn"}], "scale": [0.5, 0.7], "where": {"pathDistanceM": [14, 60]}},
 {"name": "cars", "count": 24, "objects": [{"kind": "saloon"}], "where": {"pathDistanceM": [8, 40]}},
 {"name": "bushes", "count": 150, "objects": [{"kind": "bush"}], "where": {"pathDistanceM": [6, 80]},
  "selection": {"method": "budget"}}]})";

constexpr const char* kBelowTheTour = R"({"fields": [
 {"name": "barns", "count": 250, "objects": [{"kind": "barn"}], "scale": [1, 1.5],
  "where": {"pathDistanceM": [0, 400], "slopeDeg": [0, 45]}}]})";

} // namespace

TEST(TrainerGolden, AFlightByDay)
{
    const Workplace place;
    const std::string file = place.write("flight.xosc", flightText());
    const auto frames = captured(place, {"play", file, "--eye", "chase", "--fps", "2", "--size", "240x135"});
    EXPECT_TRUE(matches(frames / "frame_00004.png", "trainer-flight"));
}

TEST(TrainerGolden, ADriveAtDuskWithScenery)
{
    const Workplace place;
    writeCrate(place);
    const std::string file = place.write("drive.xosc", pastCrateText("2024-06-21T18:50:00Z", "fourOktas"));
    const auto frames = captured(place, {"play", file, "--scenery", place.write("s.json", kRoadside), "--eye",
                                         "chase", "--fps", "3", "--size", "240x135"});
    EXPECT_TRUE(matches(frames / "frame_00004.png", "trainer-drive"));
}

TEST(TrainerGolden, ADriveThroughTwoChannels)
{
    const Workplace place;
    writeCrate(place);
    const std::string file = place.write("drive.xosc", pastCrateText("2024-06-21T09:00:00Z", "zeroOktas"));
    const auto frames =
        captured(place, {"play", file, "--view", place.write("view.xml", kTwoChannels), "--fps", "3"});
    EXPECT_TRUE(matches(frames / "left/frame_00004.png", "trainer-channel-left"));
    EXPECT_TRUE(matches(frames / "right/frame_00004.png", "trainer-channel-right"));
}

TEST(TrainerGolden, ATourWithScenery)
{
    const Workplace place;
    const auto frames =
        captured(place, {"tour", place.hill(), "--scenery", place.write("s.json", kBelowTheTour), "--fps",
                         "2", "--size", "240x135"});
    EXPECT_TRUE(matches(frames / "frame_00004.png", "trainer-tour"));
}

/// Whether all is made, found, or found to be nonsense and made anew: the picture is the same, and a second
/// opening makes nothing.
TEST(TrainerGolden, ATourFromWhatWasKept)
{
    if (rendered::writesGoldens()) GTEST_SKIP() << "goldens are being written";
    const Workplace place;
    const testsupport::UserCache cache(place.path("cache"));
    const std::filesystem::path made = place.path("cache/osgTrainer/made");
    const std::string hill = place.hill(), scenery = place.write("s.json", kBelowTheTour);
    const auto tour = [&]
    {
        return matches(
            captured(place, {"tour", hill, "--scenery", scenery, "--fps", "2", "--size", "240x135"}) /
                "frame_00004.png",
            "trainer-tour");
    };
    EXPECT_TRUE(tour());
    const auto files = testsupport::filesIn(made);
    for (const char* name :
         {"bounds-", "detail-", "grain-", "ladder-", "land-", "levels-", "normals-", "outer-", "painting-"})
        EXPECT_TRUE(files.lower_bound(name) != files.end() &&
                    files.lower_bound(name)->first.starts_with(name))
            << name;
    EXPECT_TRUE(tour());
    EXPECT_EQ(testsupport::filesIn(made), files);
    testsupport::writeNonsense(made);
    EXPECT_TRUE(tour());
    EXPECT_NE(testsupport::filesIn(made), files);
}

TEST(TrainerGolden, ADriveInRain)
{
    const Workplace place;
    const std::string file = place.write("rain.xosc", rainText());
    const auto frames = captured(place, {"play", file, "--eye", "chase", "--fps", "4", "--size", "240x135"});
    EXPECT_TRUE(matches(frames / "frame_00004.png", "trainer-rain"));
}

/// The comparison can fail: two minutes move the sun by half a degree.
TEST(TrainerGolden, TwoMinutesAreSeen)
{
    if (rendered::writesGoldens()) GTEST_SKIP() << "goldens are being written";
    const Workplace place;
    const std::string file = place.write("flight.xosc", flightText("2024-06-21T07:02:00Z"));
    const auto frames = captured(place, {"play", file, "--eye", "chase", "--fps", "2", "--size", "240x135"});
    EXPECT_FALSE(matches(frames / "frame_00004.png", "trainer-flight"));
}
