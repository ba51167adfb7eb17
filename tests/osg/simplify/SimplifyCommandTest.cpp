// SPDX-License-Identifier: Apache-2.0
// `pmtool simplify` with the arguments of the command line, in this process.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "SimplifyMeshes.h"
#include "TestFolder.h"
#include "pmtool/Commands.h"
#include "pmtool/ModelFiles.h"
#include "pmtool/Models.h"
#include "terminal/CommandLine.h"

namespace
{

class SimplifyCommand : public testing::Test
{
protected:
    /// Runs a command line and returns its result.
    foundation::Result<terminal::Report> run(const std::string& arguments)
    {
        CLI::App app;
        pmtool::Chosen chosen;
        pmtool::addSimplify(app, chosen);
        app.parse("simplify " + arguments);
        return chosen.work();
    }

    std::string model()
    {
        const auto file = _folder / "waves.obj";
        EXPECT_TRUE(pmtool::writePlain(testsupport::waves(20, 20), file));
        return file.string();
    }

    testsupport::TestFolder _folder{"simplify"};
};

TEST_F(SimplifyCommand, WritesLevelsByCountAndByError)
{
    const auto out = _folder / "out";
    const auto report = run(model() + " --targets 50,10 --tolerances 0.05 --output " + out.string());
    ASSERT_TRUE(report) << report.error().message();
    ASSERT_TRUE(report->sound);
    const auto& row = report->json["models"][0];
    EXPECT_EQ(row["triangles"], 800);
    ASSERT_EQ(row["levels"].size(), 3u);
    const std::size_t most[] = {400, 80, 800};
    for (std::size_t i = 0; i < 3; ++i)
    {
        const auto& level = row["levels"][i];
        EXPECT_LE(level["triangles"].get<std::size_t>(), most[i]);
        const auto written = pmtool::read((out / level["file"].get<std::string>()).string(), {});
        ASSERT_TRUE(written) << written.error().message();
        EXPECT_EQ(written->imported.mesh.faces.size(), level["triangles"].get<std::size_t>());
    }
    EXPECT_LE(row["levels"][2]["errorMax"].get<double>(), 0.05);
    EXPECT_GT(row["levels"][2]["errorMax"].get<double>(), 0.01);
}

TEST_F(SimplifyCommand, TakesAccumulatedQuadrics)
{
    const auto errorOf = [&](const std::string& options)
    {
        return run(model() + " --targets 10" + options)
            ->json["models"][0]["levels"][0]["errorRms"]
            .get<double>();
    };
    EXPECT_EQ(errorOf(" --quadrics memoryless"), errorOf(""));
    EXPECT_NE(errorOf(" --quadrics accumulated"), errorOf(""));
    EXPECT_THROW((void)run(model() + " --quadrics old"), CLI::ParseError);
    EXPECT_THROW((void)run(model() + " --quadrics accumulated --method removal"), CLI::ParseError);
}

TEST_F(SimplifyCommand, StopsAtAnEnvelope)
{
    const auto report = run(model() + " --envelope 0.5 --targets 1");
    ASSERT_TRUE(report);
    EXPECT_GT(report->json["models"][0]["least"].get<std::size_t>(), 8u);
    EXPECT_EQ(run(model())->json["models"][0]["least"], 0);
}

TEST_F(SimplifyCommand, NamesWhatItCannotRead)
{
    const auto report = run((_folder / "missing.obj").string());
    ASSERT_TRUE(report);
    EXPECT_FALSE(report->sound);
    EXPECT_THROW((void)run(model() + " --targets 0"), CLI::ParseError);
    EXPECT_THROW((void)run(model() + " --placement best"), CLI::ParseError);
}

} // namespace
