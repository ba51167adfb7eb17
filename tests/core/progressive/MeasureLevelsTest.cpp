// SPDX-License-Identifier: Apache-2.0
#include <sstream>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/SurfaceChange.h>
#include <osgPMObjects/core/progressive/LevelMesh.h>
#include <osgPMObjects/core/progressive/MeasureLevels.h>
#include <osgPMObjects/core/progressive/PmFile.h>
#include <osgPMObjects/core/selection/ScreenErrorRule.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "ClosedMeshes.h"
#include "PmCheckSums.h"
#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;

ProgressiveMesh measured()
{
    const Mesh mesh =
        testsupport::together(testsupport::waves(16, 16), testsupport::torus(14, 10), {20.0, 0.0, 2.0});
    ProgressiveMesh progressive = buildProgressiveMesh(mesh, simplify(mesh));
    measureLevels(progressive);
    return progressive;
}

const ProgressiveMesh& ladderSubject()
{
    static const ProgressiveMesh made = measured();
    return made;
}

TEST(MeasureLevels, GivesTheErrorsOfAnotherMeasure)
{
    const ProgressiveMesh& mesh = ladderSubject();
    ASSERT_TRUE(isValid(mesh));
    ASSERT_GT(mesh.ladder.size(), 30u);
    EXPECT_EQ(mesh.ladder.front(), MeasuredLevel{});
    const Mesh original = meshAfter(mesh, 0);
    for (std::size_t i = 1; i < mesh.ladder.size(); i += 5)
    {
        const MeasuredLevel& level = mesh.ladder[i];
        const SurfaceChange change = surfaceChange(original, meshAfter(mesh, level.steps));
        EXPECT_GE(level.error.maximum, 0.95 * change.largest) << level.steps;
        EXPECT_LE(level.error.maximum, 1.10 * change.largest) << level.steps; // which does not climb
        EXPECT_GE(level.error.rootMeanSquare, 0.97 * change.mean);
        EXPECT_LE(level.error.rootMeanSquare, level.error.maximum);
    }
}

TEST(MeasureLevels, GoesDownToTheLastLevelWithFaces)
{
    const LevelTable table = LevelTable::of(ladderSubject());
    ASSERT_TRUE(isLevelTable(table));
    EXPECT_EQ(ladderSubject().ladder.back().steps, table.mostSteps());
    for (std::size_t i = 1; i < ladderSubject().ladder.size(); ++i)
    {
        const double finer = table.faces[ladderSubject().ladder[i - 1].steps],
                     coarser = table.faces[ladderSubject().ladder[i].steps];
        EXPECT_LE(finer, std::max(LadderSettings::kMostRatio * coarser, coarser + 4.0));
    }
}

TEST(MeasureLevels, AnswersStepsToADistance)
{
    ProgressiveMesh mesh = ladderSubject();
    for (const double tolerance : {0.05, 0.3, 2.0})
    {
        const std::uint32_t steps = stepsToDistance(mesh, tolerance);
        EXPECT_LE(surfaceChange(meshAfter(mesh, 0), meshAfter(mesh, steps)).largest, 1.06 * tolerance);
        EXPECT_GE(stepsToDistance(mesh, tolerance, ErrorKind::rootMeanSquare), steps);
        EXPECT_EQ(steps, coarsestWithin(LevelTable::of(mesh), tolerance));
    }
    mesh.ladder.clear();
    EXPECT_LT(stepsToDistance(mesh, 0.3), stepsToDistance(ladderSubject(), 0.3)) << "estimates are larger";
}

TEST(MeasuredPmFile, BringsTheLadderBack)
{
    std::istringstream stream(pmBytes(ladderSubject()));
    PmReader reader(stream, "test.pm");
    std::size_t sections = 0;
    for (auto more = reader.readMore(); more && *more; more = reader.readMore(), ++sections)
    {
        const auto soFar = reader.mesh();
        ASSERT_TRUE(soFar) << soFar.error().what;
        const std::uint32_t missing = ladderSubject().stepCount - soFar->stepCount;
        const ErrorLadder here(soFar->ladder), whole(ladderSubject().ladder);
        if (sections == 0) continue; // the ladder comes after the coarsest level
        ASSERT_FALSE(here.isEmpty());
        for (std::uint32_t steps = 0; steps <= soFar->stepCount; steps += 13)
            EXPECT_EQ(here.errorAfter(steps, ErrorKind::maximum),
                      whole.errorAfter(steps + missing, ErrorKind::maximum));
    }
    EXPECT_GT(sections, 3u);
    const auto back = reader.mesh();
    ASSERT_TRUE(back);
    EXPECT_EQ(back->ladder, ladderSubject().ladder);
    EXPECT_EQ(pmBytes(*back), pmBytes(ladderSubject()));
}

TEST(MeasuredPmFile, WithoutALadderHasEstimates)
{
    ProgressiveMesh old = ladderSubject();
    old.ladder.clear();
    const std::string bytes = pmBytes(old);
    EXPECT_EQ(bytes.find("LADR"), std::string::npos);
    std::istringstream stream(bytes);
    PmReader reader(stream, "old.pm");
    for (auto more = reader.readMore(); more && *more;)
        more = reader.readMore();
    const auto back = reader.mesh();
    ASSERT_TRUE(back);
    EXPECT_TRUE(back->ladder.empty());
    const LevelTable table = LevelTable::of(*back);
    EXPECT_EQ(table.errorAfter(64, ErrorKind::rootMeanSquare), table.errors[64]);
}

TEST(MeasuredPmFile, WithALadderThatCannotBeIsRefused)
{
    const std::string good = pmBytes(ladderSubject());
    const std::size_t ladder = good.find("LADR");
    ASSERT_NE(ladder, std::string::npos);
    const std::size_t entries = ladder + 12 + 4;
    const auto refusal = [&](std::size_t at, char byte)
    {
        std::string bytes = good;
        bytes[at] = byte;
        testsupport::renewCheckSums(bytes);
        std::istringstream stream(bytes);
        PmReader reader(stream, "test.pm");
        while (true)
        {
            const auto more = reader.readMore();
            if (!more) return more.error().what;
            if (!*more) return std::string();
        }
    };
    EXPECT_EQ(refusal(entries, good[entries]), "");
    EXPECT_NE(refusal(entries, 1).find("ladder"), std::string::npos)
        << "it does not begin with the finest level";
    EXPECT_NE(refusal(entries + 12 + 3, 0x7f).find("ladder"), std::string::npos)
        << "steps that are not there";
    EXPECT_NE(refusal(entries + 12 + 7, static_cast<char>(0xff)).find("ladder"), std::string::npos)
        << "a negative error";
    EXPECT_NE(refusal(ladder + 12, 1).find("ladder"), std::string::npos) << "another number of levels";
}

TEST(ProgressiveMesh, WithALadderOfOtherLevelsIsNotValid)
{
    ProgressiveMesh wrong = ladderSubject();
    wrong.ladder.back().steps = wrong.stepCount + 1;
    EXPECT_FALSE(isValid(wrong));
    wrong.ladder.pop_back();
    EXPECT_TRUE(isValid(wrong));
    wrong.ladder.front().steps = 1;
    EXPECT_FALSE(isValid(wrong));
}

} // namespace
