// SPDX-License-Identifier: Apache-2.0
// One command from anybody's elevation file to a flight over it.
#include <string>

#include "Playing.h"
#include "RealData.h"

namespace
{

class RealTerrain : public testing::TestWithParam<const char*>
{
};

TEST_P(RealTerrain, TourGivesPicturesOfIt)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(dem, std::filesystem::path("dem") / GetParam());
    const Workplace place;
    const Playing playing = playedAs(place, "tour", {"tour", dem.string()},
                                     {"--duration", "4", "--frames", "6", "--size", "160x90"});
    ASSERT_EQ(playing.frames.size(), 6U);
    for (const auto& [name, bytes] : playing.frames)
    {
        const PictureFacts facts = factsOf(place.path("tour/" + name));
        EXPECT_EQ(facts.widthPx, 160);
        EXPECT_EQ(facts.heightPx, 90);
        EXPECT_GT(facts.colours, 500U) << name;
    }
    EXPECT_FALSE(playing.frames.at("frame_00000.png") == playing.frames.at("frame_00005.png"))
        << "nothing moves";
    for (const nlohmann::json& frame : playing.statistics.at("frames"))
        EXPECT_GT(frame.at("triangles"), 100);
}

TEST_P(RealTerrain, ValidateFindsItSound)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(dem, std::filesystem::path("dem") / GetParam());
    const Workplace place;
    const ProgramRun run =
        runTerrainTool({"validate", dem.string(), "--frames", "4", "--json", place.path("table.json")});
    ASSERT_TRUE(succeeds(run));
    const auto row = nlohmann::json::parse(readBytes(place.path("table.json"))).at("files").at(0);
    EXPECT_EQ(row.at("frames"), 4);
    EXPECT_EQ(row.at("tJunctions"), 0);
    EXPECT_EQ(row.at("cracks"), 0);
    EXPECT_EQ(row.at("ceilingExceeded"), 0);
    EXPECT_LE(row.at("maxErrorPx"), row.at("tolerancePx"));
    EXPECT_EQ(row.at("voids") > 0, std::string(GetParam()).starts_with("N46E008") ||
                                       std::string(GetParam()).starts_with("mt_fuji"));
}

INSTANTIATE_TEST_SUITE_P(Dem, RealTerrain,
                         testing::Values("N46E008.tif", "greenriver.tif", "mt_fuji_90m.tif", "S33W071.tif",
                                         "S46W066.hgt.gz"),
                         [](const testing::TestParamInfo<const char*>& test)
                         {
                             const std::string file = test.param;
                             return file.substr(0, file.find('.'));
                         });

} // namespace
