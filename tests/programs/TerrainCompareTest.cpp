// SPDX-License-Identifier: Apache-2.0
// Tests `terraintool compare`: the search for equal true error, the figures, and verdicts that follow from them.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <osgTerrainROAM/core/method/Method.h>
#include <osgTerrainROAM/core/roam/DrawnGround.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>
#include <osgTerrainROAM/core/roam/ScratchRefinement.h>

#include "Playing.h"
#include "SyntheticField.h"
#include "measurement/flights/BenchmarkFlight.h"
#include "terraintool/bench/FrameChange.h"
#include "terraintool/compare/CompareHtml.h"
#include "terraintool/compare/CompareJson.h"
#include "terraintool/compare/CompareMarkdown.h"
#include "terraintool/compare/IncoherentFrames.h"
#include "terraintool/compare/LightChange.h"
#include "terraintool/compare/MeasureRival.h"
#include "terraintool/compare/Verdicts.h"
#include "terraintool/compare/WorkFit.h"

namespace
{

using namespace osgTerrainROAM::core;
using namespace terraintool;
using nlohmann::ordered_json;
using Keys = std::vector<std::string>;

constexpr double kErrorPx = 10.0;

foundation::Result<ComparedFlight> shortFlight(const PlacedTile& tile)
{
    ComparedFlight flight{{}, kErrorPx, 4};
    for (int frame = 0; frame < 12; ++frame)
        flight.views.push_back(measurement::BenchmarkFlight{}.view(tile, frame));
    return flight;
}

const std::vector<DemComparison>& overHills()
{
    static const std::vector<DemComparison> dems{
        compareOver(testsupport::hills(129, 129), shortFlight).value()};
    return dems;
}

TEST(TerrainCompare, MeetsTheSameTrueErrorByAllMethods)
{
    for (const MethodFigures& m : overHills()[0].methods) // blocks have few levels to choose from
        EXPECT_NEAR(m.trueErrorPx, kErrorPx, (m.isOfBlocks ? 0.1 : 0.03) * kErrorPx) << m.name;
}

/// A mesh with one error whatever is asked.
class ConstantError final : public RivalMesh
{
public:
    explicit ConstantError(std::shared_ptr<const RoamTile> tile) : _mesh(std::move(tile)) {}
    RefineResult refine(const viewlod::ViewState&, const viewlod::Budget&) override
    {
        return _mesh.refine(1e-9);
    }
    DrawnMesh drawn() const override { return _mesh.drawn(); }
    std::optional<LeafOrder> order() const override { return std::nullopt; }
    WrittenSlots written() const override { return {}; }
    bool isValid() const override { return true; }
    std::size_t memoryBytes() const override { return 0; }

private:
    RoamMesh _mesh;
};

TEST(TerrainCompare, TakesTheGreatestToleranceOfThoseWithTheSameError)
{
    const auto tile = testsupport::planarTile(testsupport::hills(65, 65));
    Rival rival;
    rival.newMesh = [&] { return std::make_unique<ConstantError>(tile); };
    EXPECT_GT(toleranceForError(rival, *tile, shortFlight(tile->tile).value()), kErrorPx);
}

TEST(TerrainCompare, FindsPlausibleFigures)
{
    const DemComparison& hills = overHills()[0];
    ASSERT_EQ(hills.methods.size(), kMethods.size() + 2) << "all methods, multi-triangulations, from scratch";
    for (const MethodFigures& m : hills.methods)
    {
        EXPECT_GT(m.triangles, 100.0) << m.name;
        EXPECT_LT(m.triangles, 2.0 * 128 * 128) << m.name;
        EXPECT_GT(m.adaptUsP50, 0.0) << m.name;
        EXPECT_LE(m.adaptUsP50, m.adaptUsP99) << m.name;
        EXPECT_LE(m.adaptUsP99, m.adaptUsMax) << m.name;
        EXPECT_GT(m.changedPercent, 0.0) << m.name;
        EXPECT_LE(m.changedPercent, 100.0) << m.name;
        EXPECT_GT(m.popPx, 0.0) << m.name;
        EXPECT_GT(m.memoryMB, 0.0) << m.name;
        EXPECT_GT(m.preparationS, 0.0) << m.name;
        EXPECT_GT(m.spikeTriangles, 0.0) << m.name;
    }
    const MethodFigures &roam = *hills.of("roam"), &vdpm = *hills.of("vdpm"), &scratch = *hills.of("scratch");
    EXPECT_LT(vdpm.triangles, 0.7 * roam.triangles);
    EXPECT_LT(vdpm.ceiling->trueErrorPx, roam.ceiling->trueErrorPx) << "at equal numbers of triangles";
    EXPECT_NEAR(scratch.triangles, roam.triangles, 1e-9) << "the same meshes";
    EXPECT_NEAR(scratch.popPx, roam.popPx, 1e-9);
    EXPECT_FALSE(scratch.ceiling || scratch.slices || scratch.transformsPerTriangle);
    EXPECT_GT(roam.slices->stops, 0u);
    EXPECT_LT(hills.of("multi-triangulation")->triangles, roam.triangles);
    for (const MethodFigures& m : hills.methods)
    {
        EXPECT_EQ(m.breaks, 0u) << m.name;
        const bool follows = m.name != "vdpm" && m.name != "multi-triangulation";
        EXPECT_EQ(m.editUs.has_value(), follows) << m.name;
        EXPECT_EQ(m.morph.has_value(), m.name != "vipm-locked" && m.name != "vipm-overlapping" &&
                                           m.name != "multi-triangulation" && m.name != "scratch")
            << m.name;
        EXPECT_GT(m.areaRatio, 1.0) << m.name;
        EXPECT_EQ(m.regularPercent == 100.0, m.name == "roam" || m.name == "scratch") << m.name;
    }
    EXPECT_LT(*roam.visiblePercent, 100.0);
}

std::vector<std::array<int, 6>> cornersOf(const DiamondTree& tree)
{
    std::vector<std::array<int, 6>> corners;
    tree.forEachIn({0, 0, 128, 128},
                   [&](VertexSlot, TriangleId t)
                   {
                       if (!t.exists()) return;
                       std::array<int, 6> places{};
                       const LeafTriangle leaf = tree.vertices(t);
                       for (std::size_t i = 0; i < 3; ++i)
                       {
                           const GridPoint p = tree.place(leaf.vertices[i]).point();
                           places[2 * i] = p.column;
                           places[2 * i + 1] = p.row;
                       }
                       corners.push_back(places);
                   });
    std::sort(corners.begin(), corners.end());
    return corners;
}

TEST(TerrainCompare, GetsToTheSameMeshInEveryWay)
{
    const auto tile = testsupport::planarTile(testsupport::hills(129, 129));
    const SplitBounds bounds(tile);
    std::map<Rework, DiamondTree> trees;
    for (const Rework way : {Rework::enhMerge, Rework::oneByOne, Rework::restart})
        trees.emplace(way, bounds);
    std::uint32_t followed = 0, restarted = 0;
    for (int frame = 0; frame < 12; ++frame)
    {
        const auto view =
            measurement::BenchmarkFlight::along(measurement::Path::jump).view(tile->tile, frame);
        std::vector<GridTriangle> leaves;
        refineFromScratch(bounds, view, kErrorPx, leaves);
        for (auto& [way, tree] : trees)
        {
            const std::uint32_t changed = reworkTree(way, tree, view, kErrorPx);
            (way == Rework::restart ? restarted : followed) += changed;
            EXPECT_TRUE(tree.isConforming()) << reworkName(way);
            EXPECT_EQ(tree.leafCount(), leaves.size()) << reworkName(way);
            EXPECT_EQ(cornersOf(tree), cornersOf(trees.at(Rework::enhMerge))) << reworkName(way);
        }
        DiamondTree other(bounds);
        reworkTree(Rework::enhMerge, other, view, 2.0 * kErrorPx);
        EXPECT_NE(cornersOf(other), cornersOf(trees.at(Rework::restart))) << "another error, another mesh";
    }
    EXPECT_GT(restarted, followed / 2) << "a restart changes more triangles";
}

TEST(TerrainCompare, FindsWhatTheTimeDependsOn)
{
    std::vector<WorkSample> samples;
    for (const double triangles : {1000.0, 2000.0, 5000.0})
        for (const double written : {10.0, 20.0, 90.0})
            samples.push_back({3.0 + 2e-3 * triangles + 0.5 * written, triangles, written});
    const auto fit = fitWork(samples);
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->baseUs, 3.0, 1e-6);
    EXPECT_NEAR(fit->nsPerTriangle, 2.0, 1e-6);
    EXPECT_NEAR(fit->nsPerChange, 500.0, 1e-6);
    EXPECT_NEAR(fit->changePercent, 100.0 * 5.0 / 7.0, 1e-6) << "of the first sample";
    for (WorkSample& s : samples)
        s.us = 0.5 * s.written;
    EXPECT_NEAR(fitWork(samples)->sizePercent, 0.0, 1e-6);
    EXPECT_FALSE(fitWork({samples[0], samples[1], samples[2]})) << "too few";
    EXPECT_FALSE(fitWork(std::vector<WorkSample>(9, samples[0]))) << "all the same";
}

TEST(TerrainCompare, FindsHowTheLightChanges)
{
    const auto tile = testsupport::planarTile(testsupport::hills(65, 65));
    RoamMesh mesh(tile);
    mesh.refine(5.0);
    const DrawnMesh before = mesh.drawn();
    EXPECT_LT(lightChangeBetween(before, before).largestDeg, 1e-3);
    DrawnMesh raised = before;
    raised.vertices[before.triangles[0].vertices[0]].position.z += 1 << 20;
    EXPECT_GT(lightChangeBetween(before, raised).largestDeg, kSeenDeg);
    EXPECT_GT(lightChangeBetween(before, raised).turnedPercent, 0.0);
}

TEST(TerrainCompare, WritesTheKeysOfTheReference)
{
    const ordered_json json = comparisonJson(overHills());
    EXPECT_EQ(keysOf(json), (Keys{"dems", "claims", "qualities"}));
    const ordered_json& dem = json["dems"][0];
    EXPECT_EQ(keysOf(dem), (Keys{"dem", "methods", "requirements", "reworks"}));
    EXPECT_EQ(keysOf(dem["methods"][0]), (Keys{"name",           "triangles",      "trueErrorPx",
                                               "adaptUsP50",     "adaptUsP99",     "adaptUsMax",
                                               "changedPercent", "popPx",          "transformsPerTriangle",
                                               "memoryMB",       "preparationS",   "parts",
                                               "frameMs",        "stripLength",    "lightPercent",
                                               "lightDeg",       "regularPercent", "visiblePercent",
                                               "editUs",         "morph",          "fit"}));
    EXPECT_EQ(keysOf(dem["reworks"][0]),
              (Keys{"path", "way", "adaptUsP50", "adaptUsMax", "changedTriangles"}));
    EXPECT_EQ(keysOf(json["qualities"][0]),
              (Keys{"section", "method", "kind", "quality", "verdict", "figure"}));
    EXPECT_EQ(dem["requirements"].size(), 8 * dem["methods"].size());
    EXPECT_EQ(keysOf(dem["requirements"][0]), (Keys{"requirement", "method", "verdict", "figure"}));
    EXPECT_EQ(keysOf(json["claims"][0]), (Keys{"claim", "verdict", "figure"}));
}

/// The table without what a clock decides.
ordered_json withoutTimes(ordered_json json)
{
    for (ordered_json& dem : json["dems"])
    {
        for (ordered_json& method : dem["methods"])
        {
            for (const char* key :
                 {"adaptUsP50", "adaptUsP99", "adaptUsMax", "preparationS", "frameMs", "fit"})
                method.erase(key);
            method["editUs"] = method["editUs"].is_null();
            for (const char* key : {"us", "plainUs"})
                if (!method["morph"].is_null()) method["morph"].erase(key);
        }
        for (ordered_json& rework : dem["reworks"])
            for (const char* key : {"adaptUsP50", "adaptUsMax"})
                rework.erase(key);
        for (ordered_json& row : dem["requirements"])
            if (row["requirement"] == "R4") row = nullptr;
    }
    json["claims"] = ordered_json::array({json["claims"][0], json["claims"][1], json["claims"][2]});
    json.erase("qualities");
    return json;
}

TEST(TerrainCompare, IsTheSameInEveryRunButForTimes)
{
    const std::vector<DemComparison> again{compareOver(testsupport::hills(129, 129), shortFlight).value()};
    const ordered_json first = withoutTimes(comparisonJson(overHills()));
    EXPECT_EQ(first, withoutTimes(comparisonJson(again)));
    const std::vector<DemComparison> other{
        compareOver(testsupport::hills(129, 129, 30.0, 2), shortFlight).value()};
    EXPECT_NE(first, withoutTimes(comparisonJson(other))) << "other hills have other figures";
}

TEST(TerrainCompare, FindsWhatChangesBetweenTwoFrames)
{
    const auto tile = testsupport::planarTile(testsupport::hills(65, 65));
    const viewlod::ViewState view = measurement::BenchmarkFlight{}.view(tile->tile, 0);
    RoamMesh coarse(tile), fine(tile);
    coarse.refine(view, {.errorTolerancePx = 20.0});
    fine.refine(view, {.errorTolerancePx = 4.0});
    double popPx = 0.0; // by queries at every sample
    std::vector<glm::dvec2> places;
    for (int row = 0; row < 65; ++row)
        for (int column = 0; column < 65; ++column)
            places.emplace_back(tile->tile.frame().positionAt(column, row, 0.0));
    std::vector<std::optional<DrawnGround>> was(places.size()), is(places.size());
    drawnGroundAt(coarse.tree(), places, was);
    drawnGroundAt(fine.tree(), places, is);
    for (std::size_t i = 0; i < places.size(); ++i)
        popPx = std::max(popPx, view.pixelsPerTangent * std::abs(is[i]->position.z - was[i]->position.z) /
                                    std::max(glm::distance(is[i]->position, view.eyeWorld), view.nearM));
    const FrameChange change = changeBetween(tile->tile, coarse.drawn(), fine.drawn(), view);
    EXPECT_GT(popPx, 1.0);
    EXPECT_NEAR(change.popPx, popPx, 0.02 * popPx) << "vertices are rounded to steps";
    EXPECT_GT(change.newTriangles, 0u);
    const FrameChange none = changeBetween(tile->tile, fine.drawn(), fine.drawn(), view);
    EXPECT_EQ(none.newTriangles, 0u);
    EXPECT_EQ(none.popPx, 0.0);
}

TEST(TerrainCompare, WritesAReportOfTablesAndPlots)
{
    const std::string html = comparisonHtml(overHills());
    for (const MethodFigures& m : overHills()[0].methods)
        EXPECT_NE(html.find("<td>" + m.name + "</td>"), std::string::npos) << m.name;
    const auto count = [&](const std::string& text)
    {
        std::size_t found = 0;
        for (std::size_t at = html.find(text); at != std::string::npos; at = html.find(text, at + 1))
            ++found;
        return found;
    };
    const std::size_t methods = overHills()[0].methods.size();
    EXPECT_EQ(count("<svg"), 2u);
    EXPECT_EQ(count("<polyline"), 2 * methods);
    EXPECT_EQ(count("<table>"), count("</table>"));
    EXPECT_EQ(count("<tr>"), (1 + claimVerdicts({}).size()) + (1 + qualityVerdicts({}).size()) +
                                 2 * (1 + methods) + (1 + overHills()[0].reworks.size()) + (1 + 8 * methods))
        << "claims, qualities, figures, reworks, requirements";
    EXPECT_EQ(count("http"), count("http://www.w3.org/2000/svg")) << "needs no network";
}

/// Two methods of which every requirement and claim holds.
DemComparison goodFigures()
{
    MethodFigures good;
    good.name = "vdpm";
    good.triangles = 400.0;
    good.trueErrorPx = 2.0;
    good.adaptUsP50 = 10.0;
    good.adaptUsP99 = good.adaptUsMax = 20.0;
    good.changedPercent = 1.0;
    good.popPx = 0.5;
    good.transformsPerTriangle = 0.8;
    good.spikeTriangles = 20.0;
    good.sideSamples = 129.0;
    good.ceiling = CeilingFigures{1000.0, 1000.0, 0, 0.995, 1.0};
    good.slices = SliceFigures{5, 0};
    good.stripLength = 20.0;
    good.lightPercent = 1.0;
    good.lightDeg = 2.0;
    good.areaRatio = 64.0;
    good.visiblePercent = 20.0;
    good.followsEdits = true;
    good.memoryMB = 1.0;
    good.morph = MorphFigures{4.0, 3.0, 100.0, 10.0};
    good.fit = FitFigures{1.0, 2.0, 3.0, 20.0, 80.0};
    good.frameMs = 100.0;
    MethodFigures roam = good, blocks = good;
    roam.name = "roam";
    roam.triangles = 1000.0;
    good.fit = FitFigures{1.0, 2.0, 3.0, 80.0, 20.0};
    blocks.name = "blocks";
    blocks.isOfBlocks = true;
    blocks.triangles = 1500.0;
    MethodFigures decimated = blocks, vipm = blocks, overlapping = blocks;
    decimated.name = "regular-decimation";
    decimated.morph->vertices = 500.0;
    decimated.lightDeg = 20.0;
    vipm.name = "vipm-locked";
    overlapping.name = "vipm-overlapping";
    overlapping.triangles = 1400.0;
    DemComparison dem{"made up", {good, roam, blocks, decimated, vipm, overlapping}, {10.0, 50.0}, {}};
    for (const auto& [way, us] :
         {std::pair{"wheel", 1.0}, {"enhMerge", 2.0}, {"one by one", 3.0}, {"restart", 4.0}})
        dem.reworks.push_back({"jump", way, us, us, 10.0});
    return dem;
}

std::vector<std::string> qualitiesOf(const DemComparison& dem)
{
    std::vector<std::string> verdicts;
    for (const QualityVerdict& v : qualityVerdicts({dem}))
        verdicts.push_back(v.verdict);
    return verdicts;
}

TEST(TerrainCompare, TurnsTheVerdictOfEveryQualityByAPlantedFigure)
{
    const DemComparison good = goodFigures();
    const std::vector<std::string> verdicts = qualitiesOf(good);
    std::vector<bool> turned(verdicts.size());
    const std::vector<void (*)(MethodFigures&)> plants{[](MethodFigures& m) { m.areaRatio = 1.0; },
                                                       [](MethodFigures& m) { m.adaptUsP99 = 41.0; },
                                                       [](MethodFigures& m) { m.breaks = 1; },
                                                       [](MethodFigures& m) { m.visiblePercent = 60.0; },
                                                       [](MethodFigures& m) { m.stripLength = 3.0; },
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
    for (const char* r : {"R1", "R2", "R3", "R4", "R5", "R6", "R7", "R8"})
        EXPECT_EQ(verdictOf(dem, r), r == std::string(GetParam().requirement) ? "not met" : "met") << r;
}

INSTANTIATE_TEST_SUITE_P(TerrainCompare, PlantedFigure,
                         testing::Values(Plant{"R1", [](MethodFigures& m) { m.triangles = 1151.0; }},
                                         Plant{"R2", [](MethodFigures& m) { m.breaks = 1; }},
                                         Plant{"R3", [](MethodFigures& m) { m.spikeTriangles = 5000.0; }},
                                         Plant{"R4", [](MethodFigures& m) { m.adaptUsP99 = 41.0; }},
                                         Plant{"R5", [](MethodFigures& m) { m.transformsPerTriangle = 1.1; }},
                                         Plant{"R6", [](MethodFigures& m) { m.popPx = 1.1; }},
                                         Plant{"R6", [](MethodFigures& m) { m.changedPercent = 6.0; }},
                                         Plant{"R7", [](MethodFigures& m) { m.ceiling->framesAbove = 1; }},
                                         Plant{"R7", [](MethodFigures& m) { m.ceiling->leastShare = 0.9; }},
                                         Plant{"R7", [](MethodFigures& m) { m.ceiling->asked = 900.0; }},
                                         Plant{"R7", [](MethodFigures& m) { m.ceiling.reset(); }},
                                         Plant{"R8", [](MethodFigures& m) { m.slices->faults = 1; }},
                                         Plant{"R8", [](MethodFigures& m) { m.slices.reset(); }}));

TEST(TerrainCompare, TurnsTheVerdictOfAClaimByAPlantedFigure)
{
    const DemComparison good = goodFigures();
    const auto verdict = [&](std::size_t claim, const DemComparison& dem) {
        return claimVerdicts({good, dem})[claim].verdict;
    };
    for (std::size_t claim = 0; claim < claimVerdicts({}).size(); ++claim)
        EXPECT_EQ(verdict(claim, good), "confirmed") << claim;
    DemComparison many = good, few = good, restless = good, lean = good, slow = good;
    many.methods[0].triangles = 600.0;
    few.methods[0].triangles = 200.0;
    restless.methods[1].changedPercent = 5.5;
    lean.methods[2].triangles = 900.0;
    slow.merges.bulkNs = 60.0;
    slow.reworks[1].adaptUsP50 = 5.0; // enhMerge
    DemComparison idle = good, calm = good, lazy = good;
    idle.reworks[0].adaptUsP50 = 5.0; // wheel
    for (const std::size_t method : {1, 4, 5})
        calm.methods[method].fit->changePercent = 40.0;
    calm.methods[0].fit->sizePercent = 40.0;
    lazy.methods[3].morph->vertices = lazy.methods[3].lightDeg = 0.5;
    EXPECT_EQ(verdict(0, many), "refuted");
    EXPECT_EQ(verdict(0, few), "refuted") << "far better than the claim is not the claim";
    EXPECT_EQ(verdict(1, restless), "refuted");
    EXPECT_EQ(verdict(2, lean), "refuted");
    lean.methods[5].triangles = 1600.0;
    EXPECT_EQ(verdict(10, lean), "refuted");
    for (const std::size_t claim : {3, 4, 5})
        EXPECT_EQ(verdict(claim, slow), "refuted") << claim;
    EXPECT_EQ(verdict(6, idle), "refuted");
    for (const std::size_t claim : {7, 8, 9, 11})
        EXPECT_EQ(verdict(claim, calm), "refuted") << claim;
    for (const std::size_t claim : {12, 13})
        EXPECT_EQ(verdict(claim, lazy), "refuted") << claim;
    DemComparison less = good;
    less.methods.resize(1);
    less.merges = {};
    less.reworks.clear();
    less.methods[0].fit.reset();
    for (const ClaimVerdict& v : claimVerdicts({less}))
        EXPECT_EQ(v.verdict, "not measured") << v.claim;
}

TEST(TerrainCompare, FliesTheComparisonFlightOrAScenario)
{
    const Workplace place;
    const std::string drive = place.write("drive.xosc", driveText("hill.tif"));
    for (const Keys& flight : {Keys{}, Keys{"--flight", drive}})
    {
        Keys arguments{"compare",    place.hill(),
                       "--frames",   "6",
                       "--error",    "1",
                       "--json",     place.path("compared.json"),
                       "--html",     place.path("compared.html"),
                       "--markdown", place.path("compared.md")};
        arguments.insert(arguments.end(), flight.begin(), flight.end());
        EXPECT_TRUE(succeeds(runTerrainTool(arguments)));
        const auto json = ordered_json::parse(readBytes(place.path("compared.json")), nullptr, false);
        EXPECT_EQ(json["dems"][0]["dem"], "hill.tif");
        EXPECT_NE(readBytes(place.path("compared.html")).find("hill.tif"), std::string::npos);
        const std::string tables = readBytes(place.path("compared.md"));
        for (const char* heading : {"## Figures", "## Requirements", "## Claims of the paper",
                                    "## Advantages and drawbacks that it lists"})
            EXPECT_NE(tables.find(heading), std::string::npos) << heading;
        EXPECT_EQ(json["dems"][0]["methods"].size(), kMethods.size() + 2);
        for (const ordered_json& method : json["dems"][0]["methods"])
        {
            const auto name = method["name"].get<std::string>();
            EXPECT_EQ(method["frameMs"].is_number(), methodNamed(name).has_value()) << name;
            const std::string picture = readBytes(place.path("compared-pictures/hill-" + name + ".jpg"));
            EXPECT_EQ(picture.substr(0, 2), "\xFF\xD8") << name << ": a JPEG file";
            EXPECT_GT(picture.size(), 5000u) << name << ": with something in it";
        }
    }
}

TEST(TerrainCompare, TablesOfMarkdownHaveARowForEachFigureAndMarksThatTurn)
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

TEST(TerrainCompare, SaysWhatItCannotDo)
{
    const Workplace place;
    EXPECT_TRUE(
        failsWith(runTerrainTool({"compare", place.hill(), "--crop", "66"}), 1, "terraintool", {"square"}));
    EXPECT_TRUE(failsWith(runTerrainTool({"compare", "none.tif"}), 1, "terraintool", {"none.tif"}));
    EXPECT_EQ(runTerrainTool({"compare", place.hill(), "--error", "0"}).exitCode, 2);
    EXPECT_EQ(runTerrainTool({"compare", place.hill(), "--flight", place.path("no.xosc")}).exitCode, 2);
    EXPECT_TRUE(failsWith(
        runTerrainTool({"compare", place.hill(), "--frames", "2", "--html", place.path("no/a.html")}), 1,
        "terraintool", {"no"}));
    const std::string wrong = place.write("wrong.xosc", "<OpenSCENARIO");
    EXPECT_TRUE(failsWith(runTerrainTool({"compare", place.hill(), "--flight", wrong}), 1, "terraintool",
                          {"wrong.xosc"}));
}

} // namespace
