// SPDX-License-Identifier: Apache-2.0
// Tests that the verdicts of `compare_terrain methods` follow from its figures alone: a planted figure turns
// each of them.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "GoodFigures.h"
#include "compare/terrain/methods/CompareMarkdown.h"
#include "compare/terrain/methods/LightChange.h"
#include "compare/terrain/methods/Verdicts.h"

namespace
{

using namespace terraintool;

std::vector<std::string> qualitiesOf(const DemComparison& dem)
{
    std::vector<std::string> verdicts;
    for (const QualityVerdict& v : qualityVerdicts({dem}))
        verdicts.push_back(v.verdict);
    return verdicts;
}

TEST(CompareVerdicts, TurnsTheVerdictOfEveryQualityByAPlantedFigure)
{
    const DemComparison good = goodFigures();
    const std::vector<std::string> verdicts = qualitiesOf(good);
    std::vector<bool> turned(verdicts.size());
    const std::vector<void (*)(MethodFigures&)> plants{[](MethodFigures& m) { m.areaRatio = 1.0; },
                                                       [](MethodFigures& m) { m.adaptUsP99 = 41.0; },
                                                       [](MethodFigures& m) { m.breaks = 1; },
                                                       [](MethodFigures& m) { m.visiblePercent = 60.0; },
                                                       [](MethodFigures& m) { m.stripLength = 3.0; },
                                                       [](MethodFigures& m) { m.dualStripLength = 3.0; },
                                                       [](MethodFigures& m) { m.trueErrorPx = 3.0; },
                                                       [](MethodFigures& m)
                                                       { m.triangles = m.name == "vdpm" ? 1200.0 : 300.0; },
                                                       [](MethodFigures& m) { m.popPx = 1.1; },
                                                       [](MethodFigures& m) { m.lightDeg = 1.5 * kSeenDeg; },
                                                       [](MethodFigures& m) { m.lightDeg = 0.1; },
                                                       [](MethodFigures& m) { m.spikeTriangles = 5000.0; },
                                                       [](MethodFigures& m) { m.followsEdits = false; },
                                                       [](MethodFigures& m) { m.regularPercent = 90.0; },
                                                       [](MethodFigures& m) { m.adaptUsP50 = 30.0; },
                                                       [](MethodFigures& m) { m.ceiling->leastShare = 0.5; },
                                                       [](MethodFigures& m) { m.morph.reset(); },
                                                       [](MethodFigures& m) { m.memoryMB = 1000.0; },
                                                       [](MethodFigures& m) { m.fit->changePercent = 10.0; },
                                                       [](MethodFigures& m) { m.fit->changePercent = 90.0; },
                                                       [](MethodFigures& m) { m.frameMs = 1e-3; },
                                                       [](MethodFigures& m) { m.parts = 9.0; }};
    for (const auto& plant : plants)
        for (std::size_t method = 0; method < good.methods.size(); ++method)
        {
            DemComparison dem = good;
            plant(dem.methods[method]);
            const std::vector<std::string> planted = qualitiesOf(dem);
            for (std::size_t i = 0; i < planted.size(); ++i)
                turned[i] = turned[i] || planted[i] != verdicts[i];
        }
    const auto rows = qualityVerdicts({good});
    for (std::size_t i = 0; i < rows.size(); ++i)
        EXPECT_TRUE(turned[i]) << rows[i].method << ", " << rows[i].quality;
    for (const QualityVerdict& v : qualityVerdicts({}))
        EXPECT_EQ(v.verdict, "not measured") << v.quality;
}

std::string verdictOf(const DemComparison& dem, const std::string& requirement)
{
    for (const RequirementVerdict& v : requirementVerdicts(dem))
        if (v.requirement == requirement && v.method == "vdpm") return v.verdict;
    return "none";
}

struct Plant
{
    const char* requirement;
    void (*bad)(MethodFigures& figures);
};

class PlantedFigure : public testing::TestWithParam<Plant>
{
};

TEST_P(PlantedFigure, TurnsTheVerdictOfItsRequirementAlone)
{
    DemComparison dem = goodFigures();
    EXPECT_EQ(verdictOf(dem, GetParam().requirement), "met");
    GetParam().bad(dem.methods[0]);
    for (const char* r : {"R1", "R2", "R3", "R4", "R5 strips", "R5 slots", "R5 transforms", "R6", "R7", "R8"})
        EXPECT_EQ(verdictOf(dem, r), r == std::string(GetParam().requirement) ? "not met" : "met") << r;
}

INSTANTIATE_TEST_SUITE_P(
    CompareVerdicts, PlantedFigure,
    testing::Values(Plant{"R1", [](MethodFigures& m) { m.triangles = 1151.0; }},
                    Plant{"R2", [](MethodFigures& m) { m.breaks = 1; }},
                    Plant{"R3", [](MethodFigures& m) { m.spikeTriangles = 5000.0; }},
                    Plant{"R4", [](MethodFigures& m) { m.adaptUsP99 = 41.0; }},
                    Plant{"R5 strips", [](MethodFigures& m) { m.dualStripLength = 9.0; }},
                    Plant{"R5 slots", [](MethodFigures& m) { m.stripLength = 9.0; }},
                    Plant{"R5 transforms", [](MethodFigures& m) { m.transformsPerTriangle = 1.1; }},
                    Plant{"R6", [](MethodFigures& m) { m.popPx = 1.1; }},
                    Plant{"R6", [](MethodFigures& m) { m.changedPercent = 6.0; }},
                    Plant{"R7", [](MethodFigures& m) { m.ceiling->framesAbove = 1; }},
                    Plant{"R7", [](MethodFigures& m) { m.ceiling->leastShare = 0.9; }},
                    Plant{"R7", [](MethodFigures& m) { m.ceiling->asked = 900.0; }},
                    Plant{"R7", [](MethodFigures& m) { m.ceiling.reset(); }},
                    Plant{"R8", [](MethodFigures& m) { m.slices->faults = 1; }},
                    Plant{"R8", [](MethodFigures& m) { m.slices.reset(); }}));

TEST(CompareVerdicts, TurnsTheVerdictOfAClaimByAPlantedFigure)
{
    const DemComparison good = goodFigures();
    const auto verdict = [&](std::size_t claim, const DemComparison& dem)
    {
        const std::string alone = claimVerdicts({dem})[claim].verdict,
                          besideGood = claimVerdicts({good, dem})[claim].verdict;
        EXPECT_EQ(besideGood, alone == "confirmed" ? alone : "mixed") << claim;
        return alone;
    };
    for (std::size_t claim = 0; claim < claimVerdicts({}).size(); ++claim)
        EXPECT_EQ(verdict(claim, good), "confirmed") << claim;
    DemComparison many = good, few = good, restless = good, lean = good, slow = good;
    many.methods[0].triangles = 600.0;
    few.methods[0].triangles = 200.0;
    restless.methods[1].changedPercent = 5.5;
    lean.methods[2].triangles = 900.0;
    slow.merges.bulkNs = 60.0;
    slow.reworks[2].adaptUsP50 = 5.0; // enhMerge, all around
    DemComparison idle = good, calm = good, lazy = good;
    idle.reworks[0].adaptUsP50 = 5.0; // wheel, all around
    DemComparison slowInSight = good, idleInSight = good;
    slowInSight.reworks[3].adaptUsP50 = 5.0;
    idleInSight.reworks[1].adaptUsP50 = 5.0;
    for (const std::size_t method : {1, 4, 5, 6, 7})
        calm.methods[method].fit->changePercent = 40.0;
    calm.methods[0].fit->sizePercent = 40.0;
    lazy.methods[3].morph->vertices = lazy.methods[3].lightDeg = 0.5;
    EXPECT_EQ(verdict(0, many), "refuted");
    EXPECT_EQ(verdict(0, few), "refuted") << "far better than the claim is not the claim";
    EXPECT_EQ(verdict(1, restless), "refuted");
    EXPECT_EQ(verdict(2, lean), "mixed") << "one of four methods";
    lean.methods[5].triangles = 1600.0;
    EXPECT_EQ(verdict(15, lean), "refuted");
    for (const std::size_t claim : {3, 5, 7})
        EXPECT_EQ(verdict(claim, slow), "refuted") << claim;
    for (const std::size_t claim : {4, 6})
    {
        EXPECT_EQ(verdict(claim, slow), "confirmed") << claim;
        EXPECT_EQ(verdict(claim, slowInSight), "refuted") << claim;
    }
    EXPECT_EQ(verdict(8, idleInSight), "refuted");
    EXPECT_EQ(verdict(9, idle), "refuted");
    for (const std::size_t claim : {10, 11, 12, 13, 14, 16})
        EXPECT_EQ(verdict(claim, calm), "refuted") << claim;
    for (const std::size_t claim : {17, 18})
        EXPECT_EQ(verdict(claim, lazy), "refuted") << claim;
    DemComparison less = good;
    less.methods.resize(1);
    less.merges = {};
    less.reworks.clear();
    less.methods[0].fit.reset();
    for (const ClaimVerdict& v : claimVerdicts({less}))
        EXPECT_EQ(v.verdict, "not measured") << v.claim;
}

TEST(CompareVerdicts, TablesOfMarkdownHaveARowForEachFigureAndMarksThatTurn)
{
    DemComparison dem = goodFigures();
    const auto count = [](const std::string& text, const std::string& what)
    {
        std::size_t found = 0;
        for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
            ++found;
        return found;
    };
    const std::string good = comparisonMarkdown({dem});
    EXPECT_EQ(count(good, "| confirmed |") + count(good, "| refuted |") + count(good, "| not measured |"),
              claimVerdicts({dem}).size() + qualityVerdicts({dem}).size());
    const std::size_t marks = count(good, "−");
    dem.methods[0].breaks = 7;
    EXPECT_EQ(count(comparisonMarkdown({dem}), "−"), marks + 1) << "a requirement that is not met any more";
    EXPECT_EQ(count(comparisonMarkdown({dem, dem}), "\n| made up | vdpm |"), 2u + 2u + 2u)
        << "figures, further figures, and what it does at a ceiling";
}

TEST(CompareVerdicts, OneMeshForAllEyesHasNoTimeAndNoChanges)
{
    DemComparison dem = goodFigures();
    dem.methods[0].adapts = false;
    dem.methods[0].spikeTriangles.reset();
    for (const char* requirement : {"R3", "R4", "R6"})
        EXPECT_EQ(verdictOf(dem, requirement), "not measured") << requirement;
    EXPECT_EQ(verdictOf(dem, "R1"), "met");
}

} // namespace
