// SPDX-License-Identifier: Apache-2.0
// `compare_objects support` with the arguments of the command line, in this process.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "ClosedMeshes.h"
#include "compare/objects/Commands.h"
#include "pmtool/ModelFiles.h"
#include "terminal/CommandLine.h"

namespace
{

using nlohmann::ordered_json;

class SupportCommand : public testing::Test
{
protected:
    SupportCommand()
        : _folder(std::filesystem::temp_directory_path() / ("support-command-" + std::to_string(::getpid())))
    {
        std::filesystem::create_directories(_folder);
        EXPECT_TRUE(pmtool::writePlain(testsupport::ball(15, 24), _folder / "ball.obj"));
        EXPECT_TRUE(pmtool::writePlain(testsupport::torus(24, 12), _folder / "torus.obj"));
    }
    ~SupportCommand() override { std::filesystem::remove_all(_folder); }

    std::string file(const std::string& name) const { return (_folder / name).string(); }

    std::string textOf(const std::string& name) const
    {
        std::ifstream stream(_folder / name);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    static foundation::Result<terminal::Report> run(std::vector<std::string> arguments)
    {
        CLI::App app;
        pmtool::Chosen chosen;
        pmtool::addSupport(app, chosen);
        arguments.insert(arguments.begin(), "support");
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
        return chosen.work();
    }

private:
    std::filesystem::path _folder;
};

TEST_F(SupportCommand, TheTableHasThreeCurvesForEachModelAndTheBest)
{
    const auto report = run({file("ball.obj"), file("torus.obj"), "--depth", "2"});
    ASSERT_TRUE(report) << report.error().message();
    EXPECT_TRUE(report->sound);
    const ordered_json& table = report->json;
    ASSERT_EQ(table["models"].size(), 2u);
    EXPECT_EQ(table["octreeDepth"], 2);
    for (const ordered_json& row : table["models"])
    {
        ASSERT_EQ(row["curves"].size(), 3u);
        std::size_t supports = 0;
        double best = 1e9;
        for (const ordered_json& curve : row["curves"])
        {
            EXPECT_GE(curve["supportVertices"].get<std::size_t>(), supports) << "more with each variant";
            supports = curve["supportVertices"];
            best = std::min(best, curve["deviationToQuarterPercent"].get<double>());
            std::size_t left = 0;
            for (const auto& [reason, count] : curve["left"].items())
                left += count.get<std::size_t>();
            EXPECT_EQ(curve["removed"].get<std::size_t>() + left, row["positions"].get<std::size_t>());
        }
        EXPECT_EQ(row["curves"][0]["supportVertices"], 0);
        for (const ordered_json& curve : row["curves"])
            EXPECT_EQ(curve["support"] == row["bestToQuarter"],
                      curve["deviationToQuarterPercent"].get<double>() == best);
    }
    std::size_t models = 0;
    for (const auto& [name, count] : table["bestToFewest"].items())
        models += count.get<std::size_t>();
    EXPECT_EQ(models, 2u);
}

TEST_F(SupportCommand, CurvesAreWrittenAsCsvAndSvg)
{
    ASSERT_TRUE(run({file("ball.obj"), file("torus.obj"), "--output", file("curves")}));
    std::istringstream csv(textOf("curves/ball.csv"));
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line, "support,removed,faces,area,areaShare,error");
    std::getline(csv, line);
    EXPECT_THAT(line, testing::StartsWith("none,0,720,")) << "the whole ball first";
    EXPECT_THAT(line, testing::EndsWith(",1,0"));
    std::size_t lines = 2;
    while (std::getline(csv, line))
        ++lines;
    EXPECT_GT(lines, 100u);
    EXPECT_THAT(textOf("curves/area-curves.svg"), testing::HasSubstr("torus"));
}

TEST_F(SupportCommand, OrdersAndSeamsAreOptions)
{
    const auto flattest = run({file("ball.obj")}), shuffled = run({file("ball.obj"), "--order", "shuffled"});
    ASSERT_TRUE(flattest && shuffled);
    EXPECT_NE(flattest->json["models"][0]["curves"][0]["deviationToQuarterPercent"],
              shuffled->json["models"][0]["curves"][0]["deviationToQuarterPercent"]);
    EXPECT_TRUE(run({file("ball.obj"), "--seams", "--crease", "180", "--order", "file"}));
    EXPECT_THROW((void)run({file("ball.obj"), "--order", "backwards"}), CLI::ParseError);
    EXPECT_THROW((void)run({file("ball.obj"), "--depth", "11"}), CLI::ParseError);
}

TEST_F(SupportCommand, AMissingModelIsSaidAndTheOthersAreDone)
{
    const auto report = run({file("none.obj"), file("ball.obj")});
    ASSERT_TRUE(report);
    EXPECT_FALSE(report->sound);
    EXPECT_EQ(report->json["models"].size(), 1u);
}

TEST_F(SupportCommand, AFolderThatCannotBeIsSaidBeforeAnyWork)
{
    EXPECT_FALSE(run({file("ball.obj"), "--output", file("ball.obj")}));
}

} // namespace
