// SPDX-License-Identifier: Apache-2.0
// Builds cut into jobs from the command line.
#include <filesystem>

#include "Playing.h"

namespace
{

namespace fs = std::filesystem;

TEST(MtJobs, doneByTheirNumbersGiveTheBytesOfOneProcess)
{
    const Workplace place;
    const std::string jobs = place.path("jobs");
    EXPECT_TRUE(succeeds(runTerrainTool(
        {"mt-plan", place.hill(), "-o", jobs, "--trees", "5", "--json", place.path("plan.json")})));
    const auto plan = nlohmann::ordered_json::parse(readBytes(place.path("plan.json")))["plans"][0];
    EXPECT_EQ(keysOf(plan), (std::vector<std::string>{"folder", "points", "triangles", "jobs", "steps"}));
    const int count = plan["jobs"];
    EXPECT_TRUE(failsWith(runTerrainTool({"mt-job", jobs, std::to_string(count - 1)}), 1, "terraintool",
                          {"needs job", "first"}));
    EXPECT_TRUE(failsWith(runTerrainTool({"mt-join", jobs, "-o", place.path("early.mt")}), 1, "terraintool",
                          {"job 0 is not done"}));
    for (int job = 0; job < count; ++job)
        EXPECT_TRUE(succeeds(runTerrainTool({"mt-job", jobs, std::to_string(job)})));
    EXPECT_TRUE(succeeds(runTerrainTool({"mt-join", jobs, "-o", place.path("joined.mt")})));
    EXPECT_TRUE(
        succeeds(runTerrainTool({"mt-build", place.hill(), "-o", place.path("at-once.mt"), "--trees", "5"})));
    EXPECT_EQ(hashOf(place.path("joined.mt")), hashOf(place.path("at-once.mt")));
}

TEST(MtJobs, aPlanThatFailsLeavesNothing)
{
    const Workplace place;
    EXPECT_TRUE(failsWith(runTerrainTool({"mt-plan", place.path("none.tif"), "-o", place.path("jobs")}), 1,
                          "terraintool", {"none.tif"}));
    EXPECT_FALSE(fs::exists(place.path("jobs")));
}

} // namespace
