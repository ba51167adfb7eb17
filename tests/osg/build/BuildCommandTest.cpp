// SPDX-License-Identifier: Apache-2.0
// `pmtool build` and `info` with the arguments of the command line, in this process.
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgPMObjects/core/progressive/PmFile.h>

#include "SimplifyMeshes.h"
#include "TestFolder.h"
#include "pmtool/Commands.h"
#include "pmtool/ModelFiles.h"
#include "terminal/CommandLine.h"

namespace
{

class BuildCommand : public testing::Test
{
protected:
    /// Runs a command line and returns its result.
    foundation::Result<terminal::Report> run(const std::string& arguments)
    {
        CLI::App app;
        pmtool::Chosen chosen;
        pmtool::addBuild(app, chosen);
        pmtool::addInfo(app, chosen);
        app.parse(arguments);
        return chosen.work();
    }

    std::string model()
    {
        const auto file = _folder / "waves.obj";
        EXPECT_TRUE(pmtool::writePlain(testsupport::waves(20, 20), file));
        return file.string();
    }

    testsupport::TestFolder _folder{"build"};
};

TEST_F(BuildCommand, WritesAProgressiveMeshThatInfoLooksInto)
{
    const std::string file = (_folder / "waves.pm").string();
    for (const std::string order : {"plain", "tswap", "blocks", "ours"})
    {
        const auto report = run("build " + model() + " -o " + file + " --order " + order);
        ASSERT_TRUE(report) << report.error().message();
        EXPECT_EQ(report->json["models"][0]["triangles"], 800);
        const auto mesh = osgPMObjects::core::readPm(file);
        ASSERT_TRUE(mesh) << mesh.error().message();
        EXPECT_TRUE(isValid(*mesh));
        const auto info = run("info " + file);
        ASSERT_TRUE(info) << info.error().message();
        ASSERT_TRUE(info->sound);
        const auto& row = info->json["models"][0];
        EXPECT_EQ(row["positions"], 441);
        EXPECT_EQ(row["levels"][0]["triangles"], 800);
        EXPECT_EQ(row["levels"][2]["positions"], 110);
        EXPECT_GT(row["levels"][2]["distance"].get<double>(), 0.0);
        ASSERT_GT(row["ladder"].size(), 20u);
        EXPECT_EQ(row["ladder"][0]["triangles"], 800);
        for (std::size_t i = 1; i < row["ladder"].size(); ++i)
        {
            const auto &finer = row["ladder"][i - 1], &coarser = row["ladder"][i];
            const double triangles = coarser["triangles"].get<double>();
            EXPECT_LE(finer["triangles"].get<double>(), std::max(1.25 * triangles, triangles + 2.0));
            EXPECT_GE(coarser["errorMax"], coarser["errorRms"]);
        }
    }
}

TEST_F(BuildCommand, NamesWhatIsDamaged)
{
    const std::string file = (_folder / "waves.pm").string();
    ASSERT_TRUE(run("build " + model() + " --quantised -o " + file));
    std::fstream(file, std::ios::in | std::ios::out | std::ios::binary).seekp(700).put('?');
    const auto info = run("info " + file);
    ASSERT_TRUE(info);
    EXPECT_FALSE(info->sound);
    const auto read = osgPMObjects::core::readPm(file);
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().message(), testing::HasSubstr("check sum"));
}

TEST_F(BuildCommand, LeavesNothingWhereItCannotWrite)
{
    const auto report = run("build " + model() + " -o " + (_folder / "no/such/folder.pm").string());
    EXPECT_TRUE(!report || !report->sound);
}

} // namespace
