// SPDX-License-Identifier: Apache-2.0
// `compare_objects silhouette` with the arguments of the command line, in this process.
#include <sstream>

#include <gtest/gtest.h>

#include "TestFolder.h"
#include "compare/objects/Commands.h"
#include "terminal/CommandLine.h"

namespace
{

using nlohmann::ordered_json;
using Words = std::vector<std::string>;

foundation::Result<terminal::Report> compareSilhouette(const Words& arguments)
{
    CLI::App app;
    pmtool::Chosen chosen;
    pmtool::addCompareSilhouette(app, chosen);
    Words reversed(arguments.rbegin(), arguments.rend());
    reversed.emplace_back("silhouette");
    app.parse(reversed);
    return chosen.work();
}

/// A flat grid of 10 × 10 squares.
std::string flatGrid()
{
    std::ostringstream text;
    for (int y = 0; y <= 10; ++y)
        for (int x = 0; x <= 10; ++x)
            text << "v " << x << ' ' << y << " 0\n";
    for (int y = 0; y < 10; ++y)
        for (int x = 1; x <= 10; ++x)
            text << "f " << 11 * y + x << ' ' << 11 * y + x + 1 << ' ' << 11 * y + x + 12 << ' '
                 << 11 * y + x + 11 << '\n';
    return text.str();
}

TEST(CompareSilhouette, HasARowForEachToolAndTarget)
{
    const testsupport::TestFolder folder("compare-silhouette");
    const auto report = compareSilhouette({folder.write("sheet.obj", flatGrid()).string(), "--targets",
                                           "1,50", "--tools", "subset,optimal", "--size", "64"});
    ASSERT_TRUE(report);
    EXPECT_TRUE(report->sound);
    const ordered_json& results = report->json["models"][0]["results"];
    ASSERT_EQ(results.size(), 4U);
    EXPECT_EQ(results[0]["targetPercent"], 50.0) << "finer levels first";
    for (const ordered_json& row : results)
    {
        const int target = row["targetPercent"] == 50.0 ? 100 : 2;
        EXPECT_LE(row["trianglesReached"], target) << row;
        EXPECT_GE(row["trianglesReached"], target - 2) << row;
        EXPECT_NEAR(row["areaPercent"].get<double>(), 100.0, 1e-9) << row;
        EXPECT_NEAR(row["coveredPercent"].get<double>(), 100.0, 1e-9) << row;
        EXPECT_LE(row["leastAreaPercent"], row["mostAreaPercent"]) << row;
        EXPECT_NEAR(row["luminanceError"].get<double>(), 0.0, 1e-3) << row;
    }
}

TEST(CompareSilhouette, SeesWhatATextureDoes)
{
    const testsupport::TestFolder folder("compare-silhouette");
    const std::string model = folder.write("sheet.obj", flatGrid()).string();
    const auto report = compareSilhouette(
        {model, "--targets", "1", "--checker", "--size", "64", "--images", (folder / "images").string()});
    ASSERT_TRUE(report);
    EXPECT_LT(report->json["models"][0]["results"][0]["luminanceError"], 0.05)
        << "the sheet is flat, and so is its texture";
    EXPECT_GT(std::filesystem::file_size(folder / "images/sheet.optimal.png"), 1000U);
}

TEST(CompareSilhouette, RefusesOptionsThatMakeNoSense)
{
    EXPECT_THROW((void)compareSilhouette({"model.obj", "--tools", "best"}), CLI::ValidationError);
    EXPECT_THROW((void)compareSilhouette({"model.obj", "--views", "0"}), CLI::ValidationError);
    EXPECT_THROW((void)compareSilhouette({"model.obj", "--targets", "101"}), CLI::ValidationError);
}

} // namespace
