// SPDX-License-Identifier: Apache-2.0
// Builds cut into jobs.
#include <fstream>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <osgMultiTriangulation/core/file/BuildMtFile.h>
#include <osgMultiTriangulation/core/jobs/BuildFolder.h>

#include "HillSurface.h"
#include "TestFolder.h"

namespace osgMultiTriangulation::core
{

namespace
{

using testsupport::bytesOf;
using testsupport::TestFolder;

ForestOptions nineRectangles()
{
    ForestOptions options;
    options.treeCount = 9;
    return options;
}

void fill(SurfaceSpool& spool, const SurfaceMesh& mesh)
{
    for (const SurfacePoint& point : mesh.points)
        spool.addPoint(point);
    for (const Triangle& triangle : mesh.triangles)
        spool.addTriangle(triangle);
    EXPECT_TRUE(spool.finish());
}

void planHills(const std::filesystem::path& folder, const ForestOptions& options = nineRectangles(),
               double limitMb = 0.0, double roughnessM = 4.0)
{
    auto spool = SurfaceSpool::create(BuildFolder::incoming(folder));
    ASSERT_TRUE(spool) << spool.error().message();
    fill(*spool, testsupport::hillSurface(60, 50, roughnessM));
    const auto planned = BuildFolder::plan(*spool, {}, options, limitMb, folder);
    ASSERT_TRUE(planned) << planned.error().message();
}

std::uint32_t jobsOf(const std::filesystem::path& folder)
{
    return static_cast<std::uint32_t>(BuildFolder::open(folder)->order().partOf.size());
}

/// Does all jobs, each by a folder that is opened for it.
void doAll(const std::filesystem::path& folder)
{
    for (std::uint32_t job = 0; job < jobsOf(folder); ++job)
        EXPECT_TRUE(BuildFolder::open(folder)->doJob(job));
}

/// All bytes as one number: a difference is told in one line.
std::size_t sumOfFile(const std::filesystem::path& file)
{
    return std::hash<std::string>()(bytesOf(file));
}

std::size_t builtAtOnce(const TestFolder& folder)
{
    EXPECT_TRUE(buildMtFile(testsupport::hillSurface(60, 50), {}, nineRectangles(), folder / "at-once.mt"));
    return sumOfFile(folder / "at-once.mt");
}

std::size_t joined(const std::filesystem::path& jobs)
{
    const std::filesystem::path file = jobs.parent_path() / "joined.mt";
    const auto report = BuildFolder::open(jobs)->write(file);
    EXPECT_TRUE(report) << report.error().message();
    return sumOfFile(file);
}

TEST(BuildFolder, jobsOfAStepInAnyOrderAndTwiceGiveTheBytesOfOneProcess)
{
    const TestFolder folder("jobs");
    const std::filesystem::path jobs = folder / "jobs";
    planHills(jobs);
    const JobOrder order = BuildFolder::open(jobs)->order();
    EXPECT_GE(order.partOf.size(), 13u);
    EXPECT_EQ(order.partOf.back(), 0u) << "the whole comes last";
    for (const JobStep& step : order.steps)
        for (std::uint32_t i = step.count; i-- > 0;)
            for (int time = 0; time < 2; ++time)
            {
                const auto done = BuildFolder::open(jobs)->doJob(step.first + i);
                EXPECT_TRUE(done) << done.error().message();
            }
    doAll(jobs); // all once more
    EXPECT_EQ(joined(jobs), builtAtOnce(folder));
    EXPECT_EQ(joined(jobs), builtAtOnce(folder)) << "joining may be repeated, too";
}

TEST(BuildFolder, withinAMemoryTheBytesAreThoseOfTheSameMemory)
{
    const TestFolder folder("jobs");
    const std::filesystem::path jobs = folder / "jobs", spooled = folder / "spooled";
    planHills(jobs, {}, 48.75);
    EXPECT_GT(jobsOf(jobs), 3u);
    doAll(jobs);
    std::filesystem::create_directories(spooled);
    auto spool = SurfaceSpool::create(spooled);
    fill(*spool, testsupport::hillSurface(60, 50));
    ASSERT_TRUE(buildMtFile(*spool, {}, {}, 48.75, folder / "limited.mt"));
    EXPECT_EQ(joined(jobs), sumOfFile(folder / "limited.mt"));
    EXPECT_NE(joined(jobs), builtAtOnce(folder)) << "the control: another build has other bytes";
}

TEST(BuildFolder, processesThatDoTheSameJobsAtOnceDoNoHarm)
{
    const TestFolder folder("jobs");
    const std::filesystem::path jobs = folder / "jobs";
    planHills(jobs);
    const std::uint32_t count = jobsOf(jobs);
    std::vector<pid_t> children;
    for (int child = 0; child < 4; ++child)
    {
        children.push_back(::fork());
        if (children.back() != 0) continue;
        bool isGood = true;
        for (std::uint32_t job = 0; job < count && isGood; ++job)
            isGood = static_cast<bool>(BuildFolder::open(jobs)->doJob(job));
        ::_exit(isGood ? 0 : 1);
    }
    for (const pid_t child : children)
    {
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_EQ(status, 0);
    }
    EXPECT_EQ(joined(jobs), builtAtOnce(folder));
}

TEST(BuildFolder, theBytesShowAResultOfAnotherBuild) // the control of all comparisons here
{
    const TestFolder folder("jobs");
    const std::filesystem::path jobs = folder / "jobs", others = folder / "others";
    planHills(jobs);
    planHills(others, nineRectangles(), 0.0, 5.0);
    doAll(jobs);
    doAll(others);
    const auto whole = std::filesystem::copy_options::overwrite_existing;
    std::filesystem::copy_file(others / "parts" / "0.tree", jobs / "parts" / "0.tree", whole);
    EXPECT_NE(joined(jobs), builtAtOnce(folder));
}

TEST(BuildFolder, aJobTellsTheOneThatItNeeds)
{
    const TestFolder folder("jobs");
    const std::filesystem::path jobs = folder / "jobs";
    planHills(jobs);
    const auto opened = BuildFolder::open(jobs);
    const std::uint32_t count = jobsOf(jobs);
    const auto early = opened->doJob(count - 1);
    ASSERT_FALSE(early);
    EXPECT_NE(early.error().message().find("needs job"), std::string::npos) << early.error().message();
    EXPECT_FALSE(opened->doJob(count));
    EXPECT_FALSE(opened->write(folder / "early.mt"));
    EXPECT_FALSE(std::filesystem::exists(folder / "early.mt"));
    doAll(jobs);
    std::ofstream(jobs / "parts" / (std::to_string(opened->order().partOf[3]) + ".tree")) << "damaged";
    const auto lost = opened->write(folder / "lost.mt");
    ASSERT_FALSE(lost);
    EXPECT_NE(lost.error().message().find("job 3 is not done"), std::string::npos) << lost.error().message();
    doAll(jobs);
    EXPECT_EQ(joined(jobs), builtAtOnce(folder));
}

TEST(BuildFolder, damagedPlansAreToldAndPlannedAgain)
{
    const TestFolder folder("jobs");
    const std::filesystem::path jobs = folder / "jobs";
    planHills(jobs);
    doAll(jobs);
    const std::string manifest = bytesOf(jobs / "manifest");
    for (std::size_t at = 0; at < manifest.size(); ++at)
    {
        std::string bad = manifest;
        bad[at] = static_cast<char>(bad[at] ^ 1);
        std::ofstream(jobs / "manifest", std::ios::binary) << bad;
        EXPECT_FALSE(BuildFolder::open(jobs)) << at;
    }
    std::ofstream(jobs / "manifest", std::ios::binary) << manifest;
    EXPECT_TRUE(BuildFolder::open(jobs));
    for (const char* name : {"points", "joined", "triangles-of-parts"})
    {
        std::filesystem::resize_file(jobs / name, std::filesystem::file_size(jobs / name) - 1);
        EXPECT_FALSE(BuildFolder::open(jobs)) << name;
        planHills(jobs);
        EXPECT_TRUE(BuildFolder::open(jobs)) << name;
    }
    EXPECT_EQ(joined(jobs), builtAtOnce(folder)) << "what was done stays done";
}

TEST(BuildFolder, theSamePlanChangesNothingAndAnotherReplacesIt)
{
    const TestFolder folder("jobs");
    const std::filesystem::path jobs = folder / "jobs";
    planHills(jobs);
    doAll(jobs);
    const auto written = std::filesystem::last_write_time(jobs / "manifest");
    planHills(jobs);
    EXPECT_EQ(std::filesystem::last_write_time(jobs / "manifest"), written);
    EXPECT_FALSE(std::filesystem::exists(jobs / "incoming"));
    EXPECT_EQ(joined(jobs), builtAtOnce(folder));
    ForestOptions more;
    more.treeCount = 30;
    planHills(jobs, more);
    EXPECT_FALSE(BuildFolder::open(jobs)->write(folder / "none.mt")) << "nothing of the other is taken";
    doAll(jobs);
    EXPECT_NE(joined(jobs), builtAtOnce(folder));
}

TEST(BuildFolder, jobsKeepThePlaceOfThePlan)
{
    const TestFolder folder("mt-jobs");
    PlanFrame frame{0.0, 0.0, 30.0, 20.0};
    frame.reference = PlanReference{"PROJCS[\"a b\",\n\t…]", 500000.1, -4.0e6, 30.0, 20.0};
    auto spool = SurfaceSpool::create(BuildFolder::incoming(folder / "jobs"));
    ASSERT_TRUE(spool) << spool.error().message();
    fill(*spool, testsupport::hillSurface(60, 50));
    ASSERT_TRUE(BuildFolder::plan(*spool, frame, nineRectangles(), 0.0, folder / "jobs"));
    doAll(folder / "jobs");
    const std::size_t sum = joined(folder / "jobs");
    ASSERT_TRUE(
        buildMtFile(testsupport::hillSurface(60, 50), frame, nineRectangles(), folder / "at-once.mt"));
    EXPECT_EQ(sum, sumOfFile(folder / "at-once.mt"));
    EXPECT_NE(sum, builtAtOnce(folder)) << "the control: without a place";
}

} // namespace

} // namespace osgMultiTriangulation::core
