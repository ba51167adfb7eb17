// SPDX-License-Identifier: Apache-2.0
#include "compare/terrain/drivers/BenchParts.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include <viewlod/Slice.h>

#include <osgTerrainROAM/core/roam/DrawnGround.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "measurement/SplitFully.h"
#include "measurement/flights/BenchmarkFlight.h"
#include "measurement/flights/RandomWalk.h"

namespace terraintool
{

namespace
{

using namespace osgTerrainROAM::core;

double threadNs()
{
    return 1e3 * viewlod::Slice::threadUs();
}

/// Returns the median over repetitions of the time to remove a triangle of one subtree; 0 when it has fewer
/// than a thousand.
template<class Merge>
double nsPerRemoved(const std::shared_ptr<const RoamTile>& tile, int level, const Merge& merge)
{
    constexpr int kRepetitions = 15;
    constexpr std::uint32_t kLeast = 1000;
    DiamondTree tree(tile);
    TriangleId top = DiamondTree::kRoots[0];
    for (int i = 0; i < level; ++i)
    {
        if (tree.isLeaf(top)) tree.forceSplit(top);
        top = tree.children(top)[static_cast<std::size_t>(i % 2)];
    }
    std::vector<double> ns;
    for (int i = 0; i < kRepetitions; ++i)
    {
        measurement::splitFully(tree, {top});
        tree.clearChanges();
        const VertexSlot v = tree.splitVertex(top);
        const double begin = threadNs();
        const std::uint32_t removed = merge(tree, v);
        ns.push_back((threadNs() - begin) / removed);
        if (removed < kLeast) return 0.0;
    }
    std::nth_element(ns.begin(), ns.begin() + kRepetitions / 2, ns.end());
    return ns[kRepetitions / 2];
}

} // namespace

nlohmann::ordered_json measureMerges(const std::shared_ptr<const RoamTile>& tile)
{
    double bulkNs = 0.0, singleNs = 0.0;
    for (int level = 2; level < tile->tile.grid().levels(); level += 2)
    {
        bulkNs =
            std::max(bulkNs, nsPerRemoved(tile, level,
                                          [](DiamondTree& tree, VertexSlot v) { return tree.enhMerge(v); }));
        singleNs = std::max(
            singleNs,
            nsPerRemoved(tile, level, [](DiamondTree& tree, VertexSlot v) { return tree.forceMerge(v); }));
    }
    return {{"nsPerRemovedTriangle", bulkNs}, {"singleMergeNsPerRemovedTriangle", singleNs}};
}

nlohmann::ordered_json measureSlices(const std::shared_ptr<const RoamTile>& tile)
{
    constexpr int kFrames = measurement::RandomWalk::kFrames;
    constexpr double kSliceUs = 200.0;
    RoamMesh mesh(tile);
    measurement::RandomWalk eye(tile->tile);
    std::vector<double> us;
    int leftOver = 0;
    for (int frame = 0; frame < kFrames; ++frame)
    {
        const viewlod::ViewState& view = eye.next();
        const double before = viewlod::Slice::threadUs();
        const RefineResult result = mesh.refine(view, {.errorTolerancePx = 2.0, .maxTimeUs = kSliceUs});
        us.push_back(viewlod::Slice::threadUs() - before);
        leftOver += result.sliceBound ? 1 : 0;
    }
    std::sort(us.begin(), us.end());
    const auto pastPercent = [&](double share)
    { return std::max(us[static_cast<std::size_t>(share * (kFrames - 1))] / kSliceUs - 1.0, 0.0) * 100.0; };
    return {{"sliceUs", kSliceUs},
            {"frames", kFrames},
            {"framesLeftOver", leftOver},
            {"pastSlicePercentP99", pastPercent(0.99)},
            {"pastSlicePercentMax", pastPercent(1.0)},
            {"worstOverMedian", us.back() / us[kFrames / 2]}};
}

double measureQueries(const std::shared_ptr<const RoamTile>& tile)
{
    constexpr int kPlaces = 4096, kRounds = 25;
    RoamMesh mesh(tile);
    mesh.refine(measurement::BenchmarkFlight{}.view(tile->tile, 0), {.errorTolerancePx = 3.6});
    std::mt19937 random(9);
    std::vector<glm::dvec2> places;
    for (int i = 0; i < kPlaces; ++i)
    {
        const double column = random() / 4294967296.0 * (tile->tile.grid().dataColumns() - 1);
        const double row = random() / 4294967296.0 * (tile->tile.grid().dataRows() - 1);
        places.emplace_back(tile->tile.frame().positionAt(column, row, 0.0));
    }
    std::vector<std::optional<DrawnGround>> grounds(places.size());
    std::vector<double> ns; // of a query, by round
    for (int round = 0; round < kRounds; ++round)
    {
        const double begin = threadNs();
        drawnGroundAt(mesh.tree(), places, grounds);
        const auto found =
            std::count_if(grounds.begin(), grounds.end(), [](const auto& g) { return g.has_value(); });
        ns.push_back((threadNs() - begin) / static_cast<double>(found));
    }
    std::nth_element(ns.begin(), ns.begin() + kRounds / 2, ns.end());
    return 1e9 / ns[kRounds / 2];
}

} // namespace terraintool
