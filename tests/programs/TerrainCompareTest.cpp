// SPDX-License-Identifier: Apache-2.0
// Tests what `compare_terrain methods` measures: the search for equal true error, and the figures.
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
#include "compare/terrain/drivers/FrameChange.h"
#include "compare/terrain/methods/CompareHtml.h"
#include "compare/terrain/methods/CompareJson.h"
#include "compare/terrain/methods/CompareMarkdown.h"
#include "compare/terrain/methods/IncoherentFrames.h"
#include "compare/terrain/methods/LightChange.h"
#include "compare/terrain/methods/MeasureRival.h"
#include "compare/terrain/methods/Verdicts.h"
#include "compare/terrain/methods/WorkFit.h"
#include "measurement/flights/BenchmarkFlight.h"

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
    ASSERT_EQ(hills.methods.size(), kMethods.size() + 3)
        << "all methods, multi-triangulations, from scratch, with TINs in leaves";
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
        EXPECT_EQ(m.spikeTriangles.has_value(), m.name != "tin-leaves") << m.name;
        EXPECT_GT(m.spikeTriangles.value_or(1.0), 0.0) << m.name;
    }
    const MethodFigures &roam = *hills.of("roam"), &vdpm = *hills.of("vdpm"), &scratch = *hills.of("scratch");
    EXPECT_LT(vdpm.triangles, 0.7 * roam.triangles);
    EXPECT_LT(vdpm.ceiling->trueErrorPx, roam.ceiling->trueErrorPx) << "at equal numbers of triangles";
    EXPECT_NEAR(scratch.triangles, roam.triangles, 1e-9) << "the same meshes";
    EXPECT_NEAR(scratch.popPx, roam.popPx, 1e-9);
    for (const char* driver : {"roam-walk", "roam-queue"})
    {
        const MethodFigures& other = *hills.of(driver);
        EXPECT_NEAR(other.triangles, roam.triangles, 1e-9) << driver << ": the same meshes";
        EXPECT_NEAR(other.popPx, roam.popPx, 1e-9) << driver;
        EXPECT_NEAR(other.changedPercent, roam.changedPercent, 1e-9) << driver;
    }
    EXPECT_FALSE(scratch.ceiling || scratch.slices || scratch.transformsPerTriangle);
    EXPECT_GT(roam.slices->stops, 0u);
    EXPECT_LT(hills.of("multi-triangulation")->triangles, roam.triangles);
    for (const MethodFigures& m : hills.methods)
    {
        EXPECT_EQ(m.breaks, 0u) << m.name;
        const bool follows = m.name != "vdpm" && m.name != "multi-triangulation" && m.name != "tin-leaves";
        EXPECT_EQ(m.editUs.has_value(), follows) << m.name;
        EXPECT_EQ(m.morph.has_value(), m.name != "vipm-locked" && m.name != "vipm-overlapping" &&
                                           m.name != "multi-triangulation" && m.name != "scratch" &&
                                           m.name != "tin-leaves")
            << m.name;
        EXPECT_GT(m.areaRatio, 1.0) << m.name;
        EXPECT_EQ(m.regularPercent == 100.0, m.name.starts_with("roam") || m.name == "scratch") << m.name;
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
    EXPECT_EQ(keysOf(dem["methods"][0]), (Keys{"name",
                                               "triangles",
                                               "trueErrorPx",
                                               "adaptUsP50",
                                               "adaptUsP99",
                                               "adaptUsMax",
                                               "changedPercent",
                                               "popPx",
                                               "transformsPerTriangle",
                                               "memoryMB",
                                               "preparationS",
                                               "parts",
                                               "frameMs",
                                               "stripLength",
                                               "dualStripLength",
                                               "lightPercent",
                                               "lightDeg",
                                               "regularPercent",
                                               "visiblePercent",
                                               "editUs",
                                               "morph",
                                               "fit"}));
    EXPECT_EQ(keysOf(dem["reworks"][0]),
              (Keys{"path", "way", "adaptUsP50", "adaptUsMax", "changedTriangles"}));
    EXPECT_EQ(keysOf(json["qualities"][0]),
              (Keys{"section", "method", "kind", "quality", "verdict", "figure"}));
    EXPECT_EQ(dem["requirements"].size(), 10 * dem["methods"].size());
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
                                 2 * (1 + methods) + (1 + overHills()[0].reworks.size()) + (1 + 10 * methods))
        << "claims, qualities, figures, reworks, requirements";
    EXPECT_EQ(count("http"), count("http://www.w3.org/2000/svg")) << "needs no network";
}

} // namespace
