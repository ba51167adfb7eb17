// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgMultiTriangulation/core/check/ForestCheck.h>
#include <osgMultiTriangulation/core/split/BuildForest.h>

#include "HillSurface.h"

namespace osgMultiTriangulation::core
{

namespace
{

TEST(ForestCheck, aFlightFindsNothingWrongInAForestAndTheDamageInADamagedOne)
{
    ForestOptions options;
    options.treeCount = 6;
    const Forest good = buildForest(testsupport::hillSurface(60, 60), options)->forest;
    const ForestFlight flight = flyOver(good, 40);
    EXPECT_EQ(flight.fault, std::nullopt);
    EXPECT_EQ(flight.frames, 40);
    EXPECT_EQ(flight.checkedFrames, 5);
    EXPECT_LE(flight.worstExcessM, 1e-6);
    EXPECT_EQ(pointsOf(good).size(), 3600u);

    Forest bad = good;
    for (ForestTree& tree : bad.trees)
        for (float& error : tree.part.errors)
            error *= 0.9f;
    EXPECT_NE(flyOver(bad, 40).fault, std::nullopt) << "bounds that are too small";
    bad = good;
    std::swap(bad.trees[1].parentTriangles[0], bad.trees[1].parentTriangles[5]);
    EXPECT_NE(flyOver(bad, 40).fault, std::nullopt) << "a tree at a wrong place";
}

} // namespace

} // namespace osgMultiTriangulation::core
