// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "SimplifyMeshes.h"
#include "compare/objects/CacheRow.h"

namespace
{

using nlohmann::ordered_json;

ordered_json rowOf(const pmtool::CacheSubject& subject, const std::string& order)
{
    return pmtool::cacheRow(subject, order);
}

double meanOf(const ordered_json& row)
{
    return row["meanTransformsPerVertex"].get<double>();
}

TEST(CompareCache, MeasuresEveryOrder)
{
    const pmtool::CacheSubject subject(testsupport::waves(60, 60), 11, {.blockFaces = 256});
    for (const std::string& order : pmtool::cacheOrderNames())
    {
        const ordered_json row = rowOf(subject, order);
        EXPECT_EQ(row["order"], order);
        EXPECT_EQ(row["fifo"], 16);
        EXPECT_GE(meanOf(row), 1.0);
        EXPECT_GE(row["worstLevel"].get<double>(), meanOf(row));
        if (order == "random" || order == "scratch") continue;
        EXPECT_GT(row["nsPerStep"].get<double>(), 0.0);
        EXPECT_GT(row["bytesPerVertex"].get<double>(), 0.0);
    }
}

TEST(CompareCache, OursIsNearToFromScratchForFewMoves)
{
    const pmtool::CacheSubject subject(testsupport::waves(60, 60), 21, {.blockFaces = 512});
    const double scratch = meanOf(rowOf(subject, "scratch"));
    const ordered_json ours = rowOf(subject, "ours");
    EXPECT_LT(meanOf(ours), 1.08 * scratch);
    EXPECT_LE(ours["faceWritesPerEcol"].get<double>(), 4.0);
    // The comparison tells a bad order from a good one.
    EXPECT_GT(meanOf(rowOf(subject, "plain")), 2.0 * scratch);
    EXPECT_GT(meanOf(rowOf(subject, "random")), 3.0 * scratch);
    EXPECT_EQ(rowOf(subject, "plain")["faceWritesPerEcol"], 0.0);
}

} // namespace
