// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include <osgPMObjects/core/selection/ContinuousRule.h>
#include <osgPMObjects/core/selection/LevelTable.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "ClosedMeshes.h"
#include "SelectionScenes.h"
#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;

/// T with whole numbers alone, for z1 = p and z2 = q: (V - 2)(q² - p²) / q², halves up.
std::uint64_t exactly(std::uint64_t positions, std::uint64_t p, std::uint64_t q)
{
    if (q <= p) return 0;
    return (2 * (positions - 2) * (q * q - p * p) + q * q) / (2 * q * q);
}

/// Whether a rule is the formula to the position, for every distance of dense sweeps. `rule(z1, z2,
/// positions)`.
template<class Rule>
bool isTheFormula(const Rule& rule)
{
    for (const std::uint32_t positions : {3u, 4u, 100u, 1002u, 34'834u, 1'000'003u})
        for (std::uint64_t p : {1u, 700u, 997u})
            for (std::uint64_t q = 1; q < 20'000; q += 1 + q / 500)
                if (rule(static_cast<double>(p), static_cast<double>(q), positions) !=
                    exactly(positions, p, q))
                    return false;
    return true;
}

TEST(ContinuousRule, IsExactToThePositionOverASweepOfDistances)
{
    EXPECT_TRUE(isTheFormula([](double z1, double z2, std::uint32_t positions)
                             { return removalAt(z1, z2, positions, positions).steps; }));
}

TEST(ContinuousRule, TheSweepTellsTheObviousMistakes)
{
    const auto with = [](auto formula)
    {
        return isTheFormula(
            [&](double z1, double z2, std::uint32_t positions)
            { return z2 <= z1 ? 0u : static_cast<std::uint32_t>(formula(z1 / z2, positions)); });
    };
    EXPECT_FALSE(with([](double r, double v) { return std::round(v * (1 - r * r)); }));
    EXPECT_FALSE(with([](double r, double v) { return std::round((v - 2) * (1 - r)); }));
    EXPECT_FALSE(with([](double r, double v) { return std::floor((v - 2) * (1 - r * r)); }));
    EXPECT_FALSE(with([](double r, double v) { return std::ceil((v - 2) * (1 - r * r)); }));
}

TEST(ContinuousRule, OfTheSourcesExampleLeavesSomeFacesLess)
{ // 1000 triangles are 502 positions; from 100 m to 101 m the formula takes 10; the source (section 2.2.4) says 995 triangles
    EXPECT_EQ(removalAt(100.0, 101.0, 502, 502).steps, 10u);
    EXPECT_EQ(removalAt(100.0, 200.0, 502, 502).steps, 375u);
}

TEST(ContinuousRule, IsZeroUpToTheReference)
{
    EXPECT_EQ(removalAt(10.0, 10.0, 1000, 900), Removal{});
    EXPECT_EQ(removalAt(10.0, 0.0, 1000, 900), Removal{});
    EXPECT_EQ(removalAt(10.0, 100.0, 2, 0), Removal{});
    EXPECT_EQ(removalAt(10.0, std::nan(""), 1000, 900), Removal{});
}

TEST(ContinuousRule, ClampsAtWhatCanBeRemovedAndSaysSo)
{
    EXPECT_EQ(removalAt(1.0, 10.0, 102, 99), (Removal{99, false})); // 99 of 100
    EXPECT_EQ(removalAt(1.0, 10.0, 102, 98), (Removal{98, true}));
    EXPECT_EQ(removalAt(0.0, 10.0, 102, 100), (Removal{100, false}));
}

/// The distinct positions that a level's faces use.
std::size_t drawnPositions(const Mesh& level)
{
    std::set<std::uint32_t> used;
    for (const Face& face : level.faces)
        for (int corner = 0; corner < 3; ++corner)
            used.insert(level.positionOf(face, corner));
    return used.size();
}

/// At how many of the levels that a sweep of distances meets the drawn positions are not V - T, and how many
/// there are; when `tooMany` steps more are made than the rule says.
std::pair<int, int> levelsThatAreOff(const Mesh& mesh, std::uint32_t tooMany)
{
    const CollapseSequence sequence = simplify(mesh);
    const LevelTable table = LevelTable::of(mesh, sequence);
    EXPECT_TRUE(isLevelTable(table));
    std::set<std::uint32_t> met;
    int off = 0;
    const double z1 = referenceDistanceM(1000.0, table.area, table.faces.front());
    for (double z = 0.5 * z1; z < 20.0 * z1; z *= 1.002)
    {
        const Removal removal = removalAt(z1, z, table.positions, table.mostSteps());
        if (!met.insert(removal.steps).second) continue;
        const Mesh level = meshAfter(mesh, sequence, removal.steps + tooMany);
        EXPECT_TRUE(tooMany > 0 || level.faces.size() == table.faces[removal.steps]);
        off += drawnPositions(level) != table.positions - removal.steps;
    }
    return {off, static_cast<int>(met.size())};
}

TEST(ContinuousRule, DrawnPositionsAreVLessT)
{
    for (const Mesh& mesh : {testsupport::ball(9, 20), testsupport::torus(16, 12), testsupport::waves(14, 12),
                             testsupport::faceSoup(1, 200, 500)})
    {
        const auto [off, levels] = levelsThatAreOff(mesh, 0);
        EXPECT_EQ(off, 0) << "of " << levels;
        EXPECT_GT(levels, 140);
        EXPECT_GT(levelsThatAreOff(mesh, 1).first, 140); // one step too many is found
    }
}

TEST(ContinuousRule, ReferenceIsWhereAMeanEdgeIsOneAndAHalfPixels)
{
    // Two faces of 1 m² together: edges of 1 m; 1000 pixels a metre at 1 m.
    EXPECT_DOUBLE_EQ(referenceDistanceM(1000.0, 1.0, 2), 1000.0 / 1.5);
    EXPECT_DOUBLE_EQ(referenceDistanceM(1000.0, 1.0, 2, 3.0), 1000.0 / 3.0);
    EXPECT_EQ(referenceDistanceM(1000.0, 0.0, 0), 0.0);
}

TEST(ContinuousRule, WithABandIsCalmAndNeverCoarserThanTheFormula)
{
    Random random(11);
    int mostWithLess = 0;
    for (const double middle : {12.0, 30.0, 100.0, 400.0})
    {
        HeldLevel held;
        const auto level = [&](double band) {
            return [&, band](double d)
            { return held.level = heldRemovalAt(10.0, d, 1000, 996, band, held).steps; };
        };
        EXPECT_LE(testsupport::switchesWhileTrembling(middle, 0.05, 5, level(kDefaultBand)), 1);
        EXPECT_LE(testsupport::switchesWhileWalking(random, middle, 0.05, 1000, level(kDefaultBand)), 1);
        mostWithLess =
            std::max(mostWithLess, testsupport::switchesWhileTrembling(middle, 0.05, 5, level(1.05)));
    }
    EXPECT_GT(mostWithLess, 1);
    HeldLevel held;
    double log = 3.0;
    for (int i = 0; i < 20'000; ++i)
    {
        log = glm::clamp(log + testsupport::between(random, -0.1, 0.1), 1.0, 8.0);
        held.level = heldRemovalAt(10.0, std::exp(log), 1000, 900, kDefaultBand, held).steps;
        EXPECT_LE(held.level, removalAt(10.0, std::exp(log), 1000, 900).steps);
    }
}

} // namespace
