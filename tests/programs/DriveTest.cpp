// SPDX-License-Identifier: Apache-2.0
// `trainer drive`: a car and its driver on a street, twice, and by its recorded inputs.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string_view>

#include <foundation/CsvCells.h>

#include "ProgramRun.h"
#include "Workplace.h"

namespace
{

const char* const kStreet = OSGTRAINER_SOURCE_DIR "/data/street.xodr";
const char* const kDriven = OSGTRAINER_SOURCE_DIR "/data/vehicles/car.xml";

std::string bytesOf(const std::string& file)
{
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST(Drive, GivesTheSameBytesAgainAndByItsRecordedInputs)
{
    const Workplace place;
    const std::string inputs = place.path("inputs.csv");
    const auto driven = [&](const std::string& log, const std::string& option)
    {
        const std::string file = place.path(log);
        EXPECT_TRUE(succeeds(runTrainer({"drive", kStreet, "--headless", "--vehicle", kDriven, "--length",
                                         "150", "--duration", "8", "--csv_logger", file, option, inputs})));
        return bytesOf(file);
    };
    const std::string first = driven("first.csv", "--record-inputs"),
                      second = driven("second.csv", "--record-inputs");
    EXPECT_GT(first.size(), 10000U);
    EXPECT_EQ(first, second);
    EXPECT_EQ(first, driven("replayed.csv", "--inputs"));
}

TEST(Drive, HasTheSameTrafficAgainAndAtEveryRateOfPictures)
{
    const Workplace place;
    const auto driven = [&](const std::string& log, const std::vector<std::string>& options)
    {
        const std::string file = place.path(log);
        std::vector<std::string> words{"drive", kStreet,  "--vehicle", kDriven,        "--traffic",
                                       "30",    "--seed", "3",         "--csv_logger", file};
        words.insert(words.end(), options.begin(), options.end());
        EXPECT_TRUE(succeeds(runTrainer(words)));
        return bytesOf(file);
    };
    const std::vector<std::string> alone{"--headless", "--duration", "2"};
    const std::string first = driven("first.csv", alone);
    EXPECT_NE(first.find("Traffic 3"), std::string::npos);
    EXPECT_EQ(first, driven("second.csv", alone));
    const auto drawn = [&](const std::string& perSecond, const std::string& frames)
    {
        return driven("drawn.csv",
                      {"--fps", perSecond, "--frames", frames, "--size", "64x36", "--samples", "1",
                       "--shadows", "off", "--eye", "above", "--capture", place.path("frames" + perSecond)});
    };
    const std::string drawnAtFive = drawn("5", "10");
    EXPECT_EQ(drawnAtFive, drawn("7", "14"));
    // Of the same 2 s; the names of the plays differ.
    const auto rowsOf = [](const std::string& table) { return table.substr(table.find("Index")); };
    EXPECT_EQ(rowsOf(drawnAtFive), rowsOf(first));
}

TEST(Drive, ShowsTheLookThatTheVehiclesFileNames)
{
    const Workplace place;
    std::string text = bytesOf(kDriven);
    text.replace(text.find("version=\"1\""), 11, "version=\"1\" look=\"mine.json\"");
    const std::string car = place.write("my-car.xml", text);
    place.write("mine.json", R"({"name": "white box", "like": "van"})");
    const auto pictured = [&](const std::string& vehicle, const std::string& name)
    {
        EXPECT_TRUE(succeeds(runTrainer({"drive", kStreet, "--vehicle", vehicle, "--fps", "5", "--frames",
                                         "1", "--size", "160x90", "--samples", "1", "--shadows", "off",
                                         "--eye", "chase", "--capture", place.path(name)})));
        return bytesOf(place.path(name + "/frame_00000.png"));
    };
    const std::string usual = pictured(kDriven, "usual"), own = pictured(car, "own");
    EXPECT_GT(usual.size(), 1000U);
    EXPECT_NE(usual, own);
    EXPECT_EQ(usual, pictured(kDriven, "again"));
}

TEST(Drive, OnIceItComesLessFar)
{
    const auto drivenM = [](const std::string& surface)
    {
        const ProgramRun run = runTrainer({"drive", kStreet, "--headless", "--vehicle", kDriven, "--length",
                                           "200", "--duration", "6", "--surface", surface});
        EXPECT_TRUE(succeeds(run)) << run.text();
        const std::size_t driven = run.output.find("driven"), at = run.output.find(" s, ", driven);
        return at == std::string::npos ? 0.0 : std::atof(run.output.c_str() + at + 4);
    };
    const double dry = drivenM("asphalt");
    EXPECT_GT(dry, 20.0);
    EXPECT_LT(drivenM("ice"), 0.9 * dry);
}

/// A street whose lane says what it is made of; empty: it does not.
std::string streetOf(const Workplace& place, const std::string& surface)
{
    std::string lane = R"(<lane id="-1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/>)";
    if (!surface.empty()) lane += R"(<material sOffset="0" friction="1" surface=")" + surface + R"("/>)";
    return place.write(
        "street-of-" + surface + ".xodr",
        R"(<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="300" junction="-1">)"
        R"(<planView><geometry s="0" x="0" y="0" hdg="0" length="300"><line/></geometry></planView>)"
        R"(<lanes><laneSection s="0"><center><lane id="0" type="none"/></center><right>)" +
            lane + "</lane></right></laneSection></lanes></road></OpenDRIVE>");
}

/// The table of a drive along it.
std::string drivenOn(const Workplace& place, const std::string& surface,
                     const std::vector<std::string>& options = {})
{
    const std::string file = place.path("driven.csv");
    std::vector<std::string> words{
        "drive", streetOf(place, surface), "--headless", "--vehicle", kDriven, "--duration",
        "12",    "--csv_logger",           file};
    words.insert(words.end(), options.begin(), options.end());
    EXPECT_TRUE(succeeds(runTrainer(words)));
    return bytesOf(file);
}

TEST(Drive, TyresMeetWhatTheLaneIsMadeOf)
{
    const Workplace place;
    const std::string dry = drivenOn(place, "");
    EXPECT_GT(dry.size(), 10'000U);
    EXPECT_TRUE(drivenOn(place, "asphalt") == dry);
    EXPECT_TRUE(drivenOn(place, "unheard-of") == dry);
    for (const char* kind : {"gravel", "grass", "snow", "ice"})
    {
        const std::string driven = drivenOn(place, kind);
        EXPECT_TRUE(driven != dry) << kind;
        EXPECT_TRUE(driven == drivenOn(place, "", {"--surface", kind})) << kind;
        EXPECT_TRUE(drivenOn(place, kind, {"--surface", "asphalt"}) == dry)
            << kind << ": the option comes first";
    }
}

/// The whole numbers below a column of a table of one entity; an empty cell is none.
std::set<int> numbersBelow(const std::string& table, const std::string& column)
{
    std::string_view rest = table;
    for (int i = 0; i < 3; ++i)
        (void)foundation::takeCsvRecord(rest, ',');
    const auto names = foundation::takeCsvRecord(rest, ',').cells;
    const auto found =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), column) - names.begin());
    std::set<int> numbers;
    while (!rest.empty())
    {
        const auto cells = foundation::takeCsvRecord(rest, ',').cells;
        if (found < cells.size() && !cells[found].empty()) numbers.insert(std::stoi(cells[found]));
    }
    return numbers;
}

TEST(Drive, TellsTheGearThatIsEngaged)
{
    const Workplace place;
    const std::string table = drivenOn(place, "");
    const std::set<int> gears = numbersBelow(table, "#1 Engaged_Gear [-]");
    EXPECT_TRUE(gears.contains(1) && gears.contains(2)) << "it shifts up within twelve seconds";
    EXPECT_FALSE(numbersBelow(table, "#1 Input_gear [-]").contains(2)) << "the lever of an automatic stays";
}

TEST(Drive, TyresMeetTheWeather)
{
    const Workplace place;
    const std::string dry = drivenOn(place, "");
    EXPECT_TRUE(drivenOn(place, "", {"--weather", "rain"}) == drivenOn(place, "", {"--surface", "wet"}));
    EXPECT_TRUE(drivenOn(place, "", {"--weather", "snow"}) == drivenOn(place, "", {"--surface", "snow"}));
    EXPECT_TRUE(drivenOn(place, "", {"--weather", "fog", "--time", "22:30"}) == dry);
    EXPECT_TRUE(drivenOn(place, "", {"--weather", "rain"}) != dry);
    // Gravel is no wetter than it is.
    EXPECT_TRUE(drivenOn(place, "gravel", {"--weather", "rain"}) == drivenOn(place, "gravel"));
}

/// The cells of a table of motion beneath a column, row by row.
std::vector<std::string> columnOf(const std::string& table, const std::string& column)
{
    const auto cells = [](const std::string& line)
    {
        std::vector<std::string> parts(1);
        for (const char c : line)
            if (c == ',')
                parts.emplace_back();
            else if (c != ' ' || !parts.back().empty())
                parts.back() += c;
        return parts;
    };
    std::vector<std::string> found;
    std::istringstream lines(table);
    std::size_t at = 0;
    for (std::string line; std::getline(lines, line);)
    {
        const auto row = cells(line);
        if (line.starts_with("Index"))
            at = static_cast<std::size_t>(std::find(row.begin(), row.end(), "#1 " + column) - row.begin());
        else if (at > 0 && at < row.size())
            found.push_back(row[at]);
    }
    EXPECT_FALSE(found.empty()) << column;
    return found;
}

TEST(Drive, ItsTableTellsRoadLaneAndControls)
{
    const Workplace place;
    const std::string table = drivenOn(place, "");
    const auto s = columnOf(table, "Distance_Travelled_Along_Road_Segment [m]");
    const auto x = columnOf(table, "World_Position_X [m]");
    const auto lane = columnOf(table, "lane_id"), road = columnOf(table, "road_id");
    const auto offset = columnOf(table, "lane_offset [m]"), throttle = columnOf(table, "Input_throttle [-]");
    ASSERT_EQ(s.size(), x.size());
    double mostM = 0.0, mostThrottle = 0.0;
    for (std::size_t i = 0; i < s.size(); ++i)
    {
        EXPECT_NEAR(std::atof(s[i].c_str()) - std::atof(s[0].c_str()),
                    std::atof(x[i].c_str()) - std::atof(x[0].c_str()), 0.01)
            << "the road runs along x";
        EXPECT_EQ(lane[i], "-1");
        EXPECT_EQ(road[i], "1");
        EXPECT_LT(std::abs(std::atof(offset[i].c_str())), 0.5);
        mostM = std::max(mostM, std::atof(s[i].c_str()));
        mostThrottle = std::max(mostThrottle, std::atof(throttle[i].c_str()));
    }
    EXPECT_GT(mostM, 20.0);
    EXPECT_GT(mostThrottle, 0.1);
    EXPECT_EQ(columnOf(table, "Input_gear [-]").back(), "1.000000");
    EXPECT_EQ(columnOf(table, "Condition").back(), "sound");
    EXPECT_EQ(columnOf(table, "Input_elevator [-]").back(), "");
}

/// Two drives differ, which is no failure; beyond limits that somebody gives it is one.
TEST(Drive, TwoOfThemAreComparedByTimeAndPlace)
{
    const Workplace place;
    const std::string fast = place.write("fast.csv", drivenOn(place, "")),
                      slow = place.write("slow.csv", drivenOn(place, "", {"--speed", "5"})),
                      json = place.path("difference.json");
    const ProgramRun run = runTrainer({"compare", slow, fast, "--json", json});
    EXPECT_TRUE(succeeds(run)) << run.text();
    EXPECT_NE(run.output.find("by place"), std::string::npos) << run.text();
    EXPECT_NE(run.output.find("  time +"), std::string::npos) << run.text();
    EXPECT_NE(bytesOf(json).find("\"by_place\""), std::string::npos);
    EXPECT_TRUE(failsWith(runTrainer({"compare", slow, fast, "--fail-beyond"}), 1, "trainer", {"differ"}));
    EXPECT_TRUE(failsWith(runTrainer({"compare", slow, fast, "--position", "1"}), 1, "trainer", {"differ"}));
    EXPECT_TRUE(succeeds(runTrainer({"compare", fast, fast, "--fail-beyond"})));
    const std::string other =
        place.write("other.csv", "Index, Time, #1 Entity_Name, #1 Current_Speed, #1 World_Position_X, "
                                 "#1 World_Position_Y, #1 World_Position_Z, #1 World_Heading_Angle, \n"
                                 "0, 0, Somebody, 1, 2, 3, 4, 5, \n");
    EXPECT_TRUE(failsWith(runTrainer({"compare", other, fast}), 1, "trainer", {"none of the entities"}));
}

/// A world of the test's hill and a level road through its top, 840 m long and east to west, 300 m high;
/// `objects`: what lies on the road.
std::string roadThroughHill(const Workplace& place, const std::string& objects, const std::string& more = "")
{
    place.write(
        "through.xodr",
        R"(<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="840" junction="-1"><planView>)"
        R"(<geometry s="0" x="-420" y="0" hdg="0" length="840"><line/></geometry></planView><elevationProfile>)"
        R"(<elevation s="0" a="300" b="0" c="0" d="0"/></elevationProfile><lanes><laneSection s="0"><center>)"
        R"(<lane id="0" type="none" level="false"/></center><right><lane id="-1" type="driving" level="false">)"
        R"(<width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right></laneSection></lanes><objects>)" +
            objects + "</objects></road></OpenDRIVE>");
    return place.write("through.roam",
                       "dem = hill.tif\nroads = through.xodr\nroads_origin = 43.611222 8.218796\n"
                       "roads_heights = file\n" +
                           more);
}

constexpr double kRoadHeightM = 300.0 + 46.3; ///< of that road above the ellipsoid, as the scene has it

/// A drive begins on a lane, never inside a hill: a tunnel leads through it, and else the ground is cut down
/// to the road.
TEST(Drive, BelowAHillItBeginsOnItsLane)
{
    const Workplace place;
    for (const std::string tunnel : {"", R"(<tunnel id="t" type="standard" s="100" length="640"/>)"})
    {
        const std::string log = place.path("below.csv");
        const ProgramRun run =
            runTrainer({"drive", roadThroughHill(place, tunnel), "--headless", "--vehicle", kDriven,
                        "--duration", "3", "--start-at", "410", "--csv_logger", log});
        EXPECT_TRUE(succeeds(run)) << run.text();
        EXPECT_NE(run.output.find(", 41"), std::string::npos) << run.text();
        EXPECT_EQ(run.output.find("note"), std::string::npos) << run.text();
        // The cell 15 of a row is its height; the top of the hill lies 200 m above the road.
        std::istringstream lines(bytesOf(log));
        std::vector<double> heightsM;
        for (std::string line; std::getline(lines, line);)
        {
            std::istringstream cells(line);
            std::string cell;
            for (int i = 0; i <= 15; ++i)
                std::getline(cells, cell, ',');
            if (std::isdigit(static_cast<unsigned char>(line[0])))
                heightsM.push_back(std::atof(cell.c_str()));
        }
        ASSERT_GT(heightsM.size(), 100U);
        const auto [least, most] = std::minmax_element(heightsM.begin(), heightsM.end());
        EXPECT_LT(*most - *least, 0.5) << "it falls";
        EXPECT_NEAR(*least, kRoadHeightM, 1.0);
    }
}

TEST(Drive, SaysWhereItCannotBegin)
{
    const Workplace place;
    const auto told = [&](const std::string& world, const std::vector<std::string>& words,
                          const std::string& vehicle = kDriven)
    {
        EXPECT_TRUE(failsWith(runTrainer({"drive", world, "--headless", "--vehicle", vehicle, "--csv_logger",
                                          place.path("none.csv"), "--record-inputs", place.path("none.txt")}),
                              1, "trainer", words));
        EXPECT_FALSE(std::filesystem::exists(place.path("none.csv")));
        EXPECT_FALSE(std::filesystem::exists(place.path("none.txt")));
    };
    told(roadThroughHill(place, "", "sea_level = 1000\n"),
         {"the start at", "lies in water", "move it onto land"});
    told(place.write("bare.roam", "dem = hill.tif\n"), {"bare.roam", "no roads", "OpenDRIVE"});
    told(place.write("walk.xodr", with(bytesOf(streetOf(place, "")), "driving", "sidewalk")),
         {"walk.xodr", "no lane for cars"});
    const std::string car = bytesOf(kDriven);
    told(kStreet, {"light.xml:", "massKg"},
         place.write("light.xml", with(car, "massKg=\"1425\"", "massKg=\"-1425\"")));
    told(kStreet, {"cut.xml"}, place.write("cut.xml", car.substr(0, car.size() / 2)));
}

TEST(Drive, SaysWhatIsWrong)
{
    const Workplace place;
    EXPECT_TRUE(failsWith(runTrainer({"drive", "/nowhere.xodr", "--vehicle", kDriven}), 1, "trainer",
                          {"/nowhere.xodr"}));
    EXPECT_TRUE(failsWith(runTrainer({"drive", kStreet, "--headless", "--vehicle", "/nowhere.xml"}), 1,
                          "trainer", {"/nowhere.xml", "no such file"}));
    EXPECT_TRUE(failsWith(runTrainer({"drive", kStreet, "--headless", "--surface", "mud"}), 2, "trainer",
                          {"mud", "gravel"}));
    EXPECT_TRUE(failsWith(runTrainer({"drive", kStreet, "--headless", "--weather", "hail"}), 2, "trainer",
                          {"hail", "rain"}));
    for (const char* time : {"24:00", "8", "8:60", "8:00x"})
        EXPECT_TRUE(failsWith(runTrainer({"drive", kStreet, "--headless", "--time", time}), 1, "trainer",
                              {"--time", time}));
}

} // namespace
