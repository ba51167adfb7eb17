// SPDX-License-Identifier: Apache-2.0
#include "compare/triangulations/SweepsMt.h"

#include <algorithm>
#include <cmath>
#include <iostream>

#include <osgMultiTriangulation/core/file/BuildMtFile.h>
#include <osgMultiTriangulation/core/split/BorderFit.h>
#include <osgMultiTriangulation/core/zone/InterestZone.h>

#include "measurement/ProcessorTime.h"

namespace terraintool
{

namespace
{

using namespace osgMultiTriangulation::core;

constexpr int kSteps = 400;        ///< of a way across the surface
constexpr double kComplete = 0.05; ///< trees that are nearer are whole; shares of the width
constexpr double kNothing = 0.2;   ///< trees that are farther are not loaded

/// The place of a step on a winding way from one corner of an extent to the other.
std::pair<double, double> placeAt(const MtEntry& extent, int step)
{
    const double share = 0.1 + 0.8 * step / kSteps, aside = 0.08 * std::sin(12.0 * share);
    return {extent.low[0] + (share + aside) * (extent.high[0] - extent.low[0]),
            extent.low[1] + (share - aside) * (extent.high[1] - extent.low[1])};
}

/// Moves a zone across a file. Tells what it reads and holds, and how many triangles it can show.
foundation::Result<nlohmann::ordered_json> flownAcross(const std::filesystem::path& path, double hysteresis)
{
    const auto file = MtFile::open(path);
    if (!file) return file.error();
    const MtEntry& whole = file->info().trees[0];
    const double width = file->info().frame.stepX * (double(whole.high[0]) - whole.low[0]);
    ZoneSettings settings;
    settings.completeWithin = kComplete * width;
    settings.nothingBeyond = kNothing * width;
    settings.memoryBytes = std::size_t{1} << 32;
    settings.hysteresis = hysteresis;
    const auto zone = InterestZone::open(*file, settings);
    if (!zone) return zone.error();
    double bytes = 0.0, triangles = 0.0, trees = 0.0;
    const std::uint64_t readsBefore = (*zone)->reads(), bytesBefore = (*zone)->readBytes();
    for (int step = 0; step < kSteps; ++step)
    {
        const auto [x, y] = placeAt(whole, step);
        (*zone)->moveTo(x, y);
        Extraction& extraction = (*zone)->extraction();
        extraction.refine([](const MultiTriangulation&, std::uint32_t) { return true; });
        bytes += static_cast<double>((*zone)->memoryBytes()) / kSteps;
        triangles += static_cast<double>(extraction.active().size()) / kSteps;
        trees += static_cast<double>((*zone)->loadedTrees()) / kSteps;
    }
    return nlohmann::ordered_json{{"reads", (*zone)->reads() - readsBefore},
                                  {"readMB", static_cast<double>((*zone)->readBytes() - bytesBefore) / 1e6},
                                  {"treesMB", bytes / 1e6},
                                  {"loadedTrees", trees},
                                  {"triangles", triangles}};
}

foundation::Result<nlohmann::ordered_json>
sweepTreeCounts(const SurfaceMesh& mesh, const MtBenchRequest& request, const std::filesystem::path& path)
{
    nlohmann::ordered_json table;
    const double balanced = balancedTreeCount(static_cast<double>(mesh.points.size()), fitBorder(mesh));
    for (const double factor : {0.25, 0.5, 1.0, 2.0, 4.0})
    {
        ForestOptions options = request.options;
        options.treeCount = static_cast<std::uint32_t>(std::max(1.0, std::round(factor * balanced)));
        const auto built = buildMtFile(mesh, {}, options, path);
        if (!built) return built.error();
        const auto flown = flownAcross(path, ZoneSettings{}.hysteresis);
        if (!flown) return flown.error();
        nlohmann::ordered_json row{{"factor", factor},
                                   {"asked", options.treeCount},
                                   {"rectangles", built->rectangles},
                                   {"mainPart", built->mainPart}};
        row.update(*flown);
        std::cout << row.dump() << '\n';
        table.push_back(std::move(row));
    }
    return table;
}

foundation::Result<nlohmann::ordered_json> sweepThresholds(const std::filesystem::path& path)
{
    nlohmann::ordered_json table;
    for (const double hysteresis : {0.0, 0.05, 0.1, 0.25, 0.5, 0.75})
    {
        const auto flown = flownAcross(path, hysteresis);
        if (!flown) return flown.error();
        nlohmann::ordered_json row{{"threshold", hysteresis}};
        row.update(*flown);
        std::cout << row.dump() << '\n';
        table.push_back(std::move(row));
    }
    return table;
}

/// Squares of a grid, as the extents of trees.
std::vector<MtEntry> gridOfTrees(int side)
{
    std::vector<MtEntry> trees;
    for (int i = 0; i < side * side; ++i)
    {
        MtEntry tree;
        tree.low[0] = i % side * 100;
        tree.low[1] = i / side * 100;
        tree.high[0] = tree.low[0] + 100;
        tree.high[1] = tree.low[1] + 100;
        trees.push_back(tree);
    }
    return trees;
}

std::vector<std::uint32_t> scanned(const std::vector<MtEntry>& trees, double x, double y, double half)
{
    std::vector<std::uint32_t> found;
    for (std::uint32_t t = 0; t < trees.size(); ++t)
        if (trees[t].low[0] <= x + half && trees[t].high[0] >= x - half && trees[t].low[1] <= y + half &&
            trees[t].high[1] >= y - half)
            found.push_back(t);
    return found;
}

/// Asks for the trees in a square of nine or so of them.
foundation::Result<nlohmann::ordered_json> sweepIndex()
{
    nlohmann::ordered_json table;
    for (const int side : {4, 8, 32, 100, 316})
    {
        const std::vector<MtEntry> trees = gridOfTrees(side);
        const TreeIndex index(trees);
        const int queries = std::max(50, 400000 / (side * side));
        std::size_t byTree = 0, byScan = 0;
        const auto ask = [&](const auto& query)
        {
            const double before = measurement::processorMs();
            for (int q = 0; q < queries; ++q)
                query(100.0 * (q * 37 % side) + 30.0, 100.0 * (q * 53 % side) + 70.0);
            return 1000.0 * (measurement::processorMs() - before) / queries;
        };
        const double treeUs =
            ask([&](double x, double y) { byTree += index.near(x, y, 100.0, 100.0).size(); });
        const double scanUs = ask([&](double x, double y) { byScan += scanned(trees, x, y, 100.0).size(); });
        if (byTree != byScan)
            return foundation::Error{"the R-tree", "finds other trees than a scan", "report this"};
        nlohmann::ordered_json row{{"trees", side * side}, {"rTreeUs", treeUs}, {"scanUs", scanUs}};
        std::cout << row.dump() << '\n';
        table.push_back(std::move(row));
    }
    return table;
}

} // namespace

foundation::Result<nlohmann::ordered_json> sweepsOver(const SurfaceMesh& mesh, const MtBenchRequest& request)
{
    const std::filesystem::path path = request.folder / "sweeps.mt";
    const auto treeCounts = sweepTreeCounts(mesh, request, path);
    if (!treeCounts) return treeCounts.error();
    const auto built = buildMtFile(mesh, {}, request.options, path);
    if (!built) return built.error();
    const auto thresholds = sweepThresholds(path);
    if (!thresholds) return thresholds.error();
    const auto index = sweepIndex();
    if (!index) return index.error();
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    return nlohmann::ordered_json{
        {"treeCounts", *treeCounts}, {"thresholds", *thresholds}, {"index", *index}};
}

} // namespace terraintool
