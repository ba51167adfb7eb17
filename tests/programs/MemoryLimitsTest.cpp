// SPDX-License-Identifier: Apache-2.0
// Programs under limits of address space: they do their work, or say in one line what they lacked; nothing
// half-written is left.
#include <algorithm>
#include <filesystem>
#include <sstream>

#include "Playing.h"
#include "ProgramRun.h"
#include "Workplace.h"

namespace
{

using Command = std::vector<std::string>;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

ProgramRun underLimit(int mebibytes, std::vector<std::string> command)
{
    command.insert(command.begin(),
                   {"sh", "-c", "ulimit -v " + std::to_string(mebibytes * 1024) + "; exec \"$@\"", "sh"});
    return runProgram(command);
}

/// Fails unless the program did its work, or ended with one error that names a remedy.
void expectDoneOrTold(const ProgramRun& run, const std::string& program, const std::string& what)
{
    if (run.exitCode == 0) return;
    EXPECT_EQ(run.exitCode, 1) << what << ": " << run.text();
    std::size_t errors = 0;
    for (const std::string& line : linesOf(run.errors))
        errors += line.starts_with(program + ": ") && line.find("; ") != std::string::npos;
    EXPECT_EQ(errors, 1U) << what << ": " << run.text();
}

/// Returns the least address space, in steps of 5 MiB, in which a program can load its libraries.
int leastToStart(const std::string& program)
{
    int mebibytes = 120;
    while (mebibytes < 1000 && underLimit(mebibytes, {program, "--version"}).exitCode != 0)
        mebibytes += 5;
    return mebibytes;
}

/// Runs commands under limits, and sees that those which fail leave no file.
class Limits
{
public:
    explicit Limits(const Workplace& place) : _place(place), _before(files()) {}

    void run(const std::string& program, const Command& command, const std::vector<int>& mebibytes)
    {
        for (const int limit : mebibytes)
        {
            const ProgramRun run = underLimit(limit, command);
            const std::string what = program + ' ' + command[1] + " under " + std::to_string(limit) + " MiB";
            const bool isLoaded = run.exitCode != 127; // below that the loader cannot map the libraries
            if (isLoaded) expectDoneOrTold(run, program, what);
            _told += run.exitCode == 1;
            if (run.exitCode == 0)
                removeNew();
            else
                EXPECT_EQ(files(), _before) << what;
        }
    }

    /// Fails where no limit was too small: then the test shows nothing.
    void expectSomeTold(std::size_t least) const { EXPECT_GE(_told, least); }

private:
    /// Folders do not count: they were asked for.
    std::vector<std::string> files() const
    {
        std::vector<std::string> names = _place.files();
        std::erase_if(names, [&](const std::string& name)
                      { return std::filesystem::is_directory(_place.path(name)); });
        return names;
    }

    void removeNew() const
    {
        for (const std::string& file : files())
            if (std::find(_before.begin(), _before.end(), file) == _before.end())
                std::filesystem::remove(_place.path(file));
    }

    const Workplace& _place;
    std::vector<std::string> _before;
    std::size_t _told = 0;
};

/// A wave of so many squares a side, as .obj.
std::string waves(int squares)
{
    std::ostringstream text;
    for (int y = 0; y <= squares; ++y)
        for (int x = 0; x <= squares; ++x)
            text << "v " << x << ' ' << y << ' ' << 0.125 * (x * y % 7) << '\n';
    const int row = squares + 1;
    for (int y = 0; y < squares; ++y)
        for (int x = 1; x <= squares; ++x)
            text << "f " << row * y + x << ' ' << row * y + x + 1 << ' ' << row * (y + 1) + x + 1 << ' '
                 << row * (y + 1) + x << '\n';
    return text.str();
}

TEST(MemoryLimits, EveryCommandSaysWhatItLacks)
{
    if (kIsSanitized) GTEST_SKIP() << "NOT TESTED: sanitizers reserve more address space than there is";
    const Workplace place;
    Limits limits(place);
    const auto sized = [&](const char* size)
    {
        return Command{OSGTRAINER_TRAINER, "tour", "--no-world", place.hill(),
                       "--frames",         "1",    "--stats",    place.path("stats.json"),
                       "--size",           size};
    };
    for (const Command& command : {sized("64x36"), sized("2048x2048")})
        limits.run("trainer", command, {330, 360, 420, 600});
    limits.run("terraintool", {OSGTRAINER_TERRAINTOOL, "info", place.hill()}, {330, 360, 420, 600});
    limits.expectSomeTold(1);
}

TEST(MemoryLimits, EveryCommandOfPmtoolSaysWhatItLacks)
{
    if (kIsSanitized) GTEST_SKIP() << "NOT TESTED: sanitizers reserve more address space than there is";
    const Workplace place;
    const std::string model = place.write("waves.obj", waves(64)), pmtool = OSGTRAINER_PMTOOL;
    const int least = leastToStart(pmtool);
    Limits limits(place);
    for (const Command& command : std::initializer_list<Command>{
             {pmtool, "info", model},
             {pmtool, "consolidate", model, "--output", place.path("whole"), "--dump", place.path("plain")},
             {pmtool, "bake", model, "--output", place.path("baked")},
             {pmtool, "simplify", model, "--output", place.path("levels"), "--targets", "20"},
             {pmtool, "build", model, "-o", place.path("model.pm")},
             {pmtool, "tessellate", model, "--output", place.path("cut")}})
        limits.run("pmtool", command, {least, least + 5});
    limits.expectSomeTold(6);
}

TEST(MemoryLimits, EveryComparisonOfObjectsSaysWhatItLacks)
{
    if (kIsSanitized) GTEST_SKIP() << "NOT TESTED: sanitizers reserve more address space than there is";
    const Workplace place;
    const std::string model = place.write("waves.obj", waves(64)), compare = OSGTRAINER_COMPARE_OBJECTS;
    const int least = leastToStart(compare);
    Limits limits(place);
    for (const Command& command :
         std::initializer_list<Command>{{compare, "support", model, "--output", place.path("curves")},
                                        {compare, "order", model},
                                        {compare, "cache", model},
                                        {compare, "simplify", model, "--targets", "20"},
                                        {compare, "silhouette", model}})
        limits.run("compare_objects", command, {least, least + 5});
    limits.expectSomeTold(5);
}

TEST(MemoryLimits, EveryCommandOfRoadtoolSaysWhatItLacks)
{
    if (kIsSanitized) GTEST_SKIP() << "NOT TESTED: sanitizers reserve more address space than there is";
    const Workplace place;
    const std::string roads = OSGTRAINER_SOURCE_DIR "/tests/fuzz/corpus/junction.xodr",
                      roadtool = OSGTRAINER_ROADTOOL;
    const int least = leastToStart(roadtool);
    Limits limits(place);
    for (const char* command : {"info", "validate"})
        limits.run("roadtool", {roadtool, command, roads, "--json", place.path("table.json")},
                   {least, least + 5});
    limits.run("roadtool",
               {roadtool, "draw", roads, "--svg", place.path("roads.svg"), "--png", place.path("roads.png"),
                "--pixels", "3000"},
               {least, least + 5, least + 10, least + 15});
    limits.expectSomeTold(2);
}

/// So many streets of five nodes each, about the hill, as .osm.
std::string streetMap(int streets)
{
    std::ostringstream text;
    text.precision(9);
    text << "<osm version=\"0.6\">\n";
    for (int node = 0; node < 5 * streets; ++node)
        text << "<node id=\"" << node + 1 << "\" lat=\"" << 43.6108 + 1e-7 * (node / 5 % 9000) << "\" lon=\""
             << 8.2110 + 2e-5 * (node % 5) << "\"/>\n";
    for (int way = 0; way < streets; ++way)
    {
        text << "<way id=\"" << way + 1 << "\">";
        for (int i = 1; i <= 5; ++i)
            text << "<nd ref=\"" << 5 * way + i << "\"/>";
        text << "<tag k=\"highway\" v=\"residential\"/></way>\n";
    }
    return text.str() + "</osm>\n";
}

TEST(MemoryLimits, AHugeMapIsToldAndLeavesNoWorld)
{
    if (kIsSanitized) GTEST_SKIP() << "NOT TESTED: sanitizers reserve more address space than there is";
    const Workplace place;
    const std::string worldtool = OSGTRAINER_WORLDTOOL, small = place.write("small.osm", streetMap(1)),
                      huge = place.write("huge.osm", streetMap(60000));
    const auto build = [&](const std::string& map)
    { return Command{worldtool, "build", place.hill(), "--map", map, "-o", place.path("world")}; };
    const int mebibytes = leastToStart(worldtool) + 90;
    const ProgramRun control = underLimit(mebibytes, build(small));
    EXPECT_EQ(control.exitCode, 0) << "the control: a small map fits; " << control.text();
    std::filesystem::remove_all(place.path("world"));
    Limits limits(place);
    limits.run("worldtool", build(huge), {mebibytes - 60, mebibytes});
    limits.expectSomeTold(2);
}

} // namespace
