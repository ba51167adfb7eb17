// SPDX-License-Identifier: Apache-2.0
#include "compare/objects/CacheRow.h"

#include <algorithm>
#include <functional>
#include <random>

#include <osgPMObjects/core/order/TriangleOrders.h>
#include <osgPMObjects/core/order/VertexCacheCost.h>
#include <osgPMObjects/core/progressive/CompactedLevel.h>
#include <osgPMObjects/core/progressive/LevelMesh.h>
#include <osgPMObjects/core/progressive/ProgressiveLevel.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "pmtool/Timing.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects::core;
using Json = nlohmann::ordered_json;
using Calls = std::vector<std::vector<Triangle>>;

constexpr const char* kRandom = "random";
constexpr const char* kCompaction = "compaction";
constexpr const char* kScratch = "scratch";

struct NamedArrangement
{
    const char* name;
    Arrangement arrangement;
};
constexpr std::array<NamedArrangement, 4> kArrangements{{{"plain", Arrangement::plain},
                                                         {"tswap", Arrangement::tswap},
                                                         {"blocks", Arrangement::blocks},
                                                         {"ours", Arrangement::windows}}};

double transformsPerVertex(const CacheSubject& subject, const Calls& calls)
{
    const auto wedges = static_cast<std::uint32_t>(subject.mesh.wedgeCount());
    std::vector<bool> isUsed(wedges, false);
    std::uint64_t transforms = 0;
    for (const std::vector<Triangle>& call : calls)
    {
        transforms += fifoTransforms(call, wedges, subject.settings.cacheSize);
        for (const Triangle& triangle : call)
            for (const std::uint32_t wedge : triangle)
                isUsed[wedge] = true;
    }
    const auto used = std::count(isUsed.begin(), isUsed.end(), true);
    return used == 0 ? 1.0 : static_cast<double>(transforms) / static_cast<double>(used);
}

/// The mean of all levels, each with the same weight, and the worst of them.
void addTransforms(const CacheSubject& subject, const std::function<Calls(std::uint32_t)>& callsOf, Json& row)
{
    double sum = 0.0, worst = 0.0;
    for (const std::uint32_t steps : subject.levels)
    {
        const double transforms = transformsPerVertex(subject, callsOf(steps));
        sum += transforms;
        worst = std::max(worst, transforms);
    }
    row["meanTransformsPerVertex"] = sum / static_cast<double>(subject.levels.size());
    row["worstLevel"] = worst;
}

ProgressiveMesh progressiveOf(const CacheSubject& subject, Arrangement arrangement)
{
    ArrangementSettings settings = subject.settings;
    settings.arrangement = arrangement;
    return buildProgressiveMesh(subject.mesh, subject.sequence, settings);
}

Calls callsOf(const ProgressiveMesh& progressive, const CompactedLevel& level)
{
    Calls calls;
    for (std::uint32_t group = 0; group < progressive.groups.size(); ++group)
    {
        const SlotRange range = level.rangeOf(group);
        auto& call = calls.emplace_back();
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i)
            call.push_back(level.triangle(i));
    }
    return calls;
}

/// Returns faces without holes, since holes transform nothing.
Calls callsOf(const ProgressiveMesh& progressive, const ProgressiveLevel& level)
{
    Calls calls(progressive.groups.size());
    forEachDrawnFace(progressive, level,
                     [&](const Triangle& face, std::uint32_t group) { calls[group].push_back(face); });
    return calls;
}

/// The same for the levels of a progressive mesh, as a player draws them.
template<class Level>
void addTransforms(const CacheSubject& subject, const ProgressiveMesh& progressive, Level& level, Json& row)
{
    addTransforms(
        subject,
        [&](std::uint32_t steps)
        {
            level.moveTo(steps);
            return callsOf(progressive, level);
        },
        row);
}

/// How many slots are drawn for each face, on average over the levels.
double slotsPerFace(const CacheSubject& subject, const ProgressiveMesh& progressive, ProgressiveLevel& level)
{
    double sum = 0.0;
    for (const std::uint32_t steps : subject.levels)
    {
        level.moveTo(steps);
        std::vector<SlotRange> ranges;
        for (std::uint32_t group = 0; group < progressive.groups.size(); ++group)
            level.appendRanges(group, ranges);
        std::uint32_t slots = 0;
        for (const SlotRange& range : ranges)
            slots += range.count;
        sum += static_cast<double>(slots) / std::max(1u, level.faceCount());
    }
    return sum / static_cast<double>(subject.levels.size());
}

Json arrangementRow(const CacheSubject& subject, const NamedArrangement& named)
{
    ProgressiveMesh progressive;
    Json row{{"order", named.name}, {"fifo", subject.settings.cacheSize}};
    const double buildMs = millisecondsOf([&] { progressive = progressiveOf(subject, named.arrangement); });
    ProgressiveLevel level(progressive);
    addTransforms(subject, progressive, level, row);
    row["slotsPerFace"] = slotsPerFace(subject, progressive, level);

    ProgressiveLevel played(progressive);
    played.moveTo(0);
    const StepStatistics all = played.statistics();
    const double steps = std::max(1u, progressive.stepCount);
    row["faceWritesPerEcol"] = static_cast<double>(all.facesMoved) / steps;
    row["facesPatchedPerEcol"] = static_cast<double>(all.facesPatched) / steps;
    row["holesPerEcol"] =
        named.arrangement == Arrangement::windows ? static_cast<double>(all.facesVanished) / steps : 0.0;
    std::vector<double> ns;
    constexpr int kRuns = 9;
    for (int run = 0; run < kRuns; ++run)
        ns.push_back(1e6 / (2.0 * steps) *
                     threadMillisecondsOf(
                         [&]
                         {
                             played.moveTo(progressive.stepCount);
                             played.moveTo(0);
                         }));
    std::sort(ns.begin(), ns.end());
    row["nsPerStep"] = ns[kRuns / 2];
    row["bytesPerVertex"] =
        static_cast<double>(progressive.overheadBytes()) / static_cast<double>(progressive.mesh.wedgeCount());
    row["buildMs"] = buildMs;
    return row;
}

std::vector<Triangle> trianglesOf(const CompactedLevel& level)
{
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < level.triangleCount(); ++i)
        triangles.push_back(level.triangle(i));
    return triangles;
}

/// Counts the faces that change their slot at a step, when all faces after the first removed one move up.
double writesOfCompaction(const CacheSubject& subject, CompactedLevel& level)
{
    double sum = 0.0;
    for (const std::uint32_t steps : subject.levels)
    {
        level.moveTo(steps);
        const std::vector<Triangle> before = trianglesOf(level);
        level.moveTo(steps + 1);
        const std::vector<Triangle> after = trianglesOf(level);
        const auto same = std::mismatch(after.begin(), after.end(), before.begin()).first - after.begin();
        sum += static_cast<double>(after.size()) - static_cast<double>(same);
    }
    return sum / static_cast<double>(subject.levels.size());
}

Json compactionRow(const CacheSubject& subject)
{
    // The order of the full mesh is the library's, as that of blocks.
    const ProgressiveMesh progressive = progressiveOf(subject, Arrangement::blocks);
    CompactedLevel level(progressive);
    Json row{{"order", kCompaction}, {"fifo", subject.settings.cacheSize}};
    addTransforms(subject, progressive, level, row);
    row["faceWritesPerEcol"] = writesOfCompaction(subject, level);
    std::vector<double> ns;
    for (const std::uint32_t steps : subject.levels)
        ns.push_back(1e6 * threadMillisecondsOf([&] { level.moveTo(steps); }));
    std::sort(ns.begin(), ns.end());
    row["nsPerStep"] = ns[ns.size() / 2];
    row["bytesPerVertex"] = static_cast<double>(progressive.overheadBytes() - progressive.records.size()) /
                            static_cast<double>(progressive.mesh.wedgeCount());
    return row;
}

/// Every level in an order of its own.
Json freshRow(const CacheSubject& subject, const char* name,
              const std::function<std::vector<Triangle>(std::vector<Triangle>)>& ordered)
{
    const ProgressiveMesh progressive = progressiveOf(subject, Arrangement::plain);
    CompactedLevel level(progressive);
    Json row{{"order", name}, {"fifo", subject.settings.cacheSize}};
    addTransforms(
        subject,
        [&](std::uint32_t steps)
        {
            level.moveTo(steps);
            Calls calls = callsOf(progressive, level);
            for (std::vector<Triangle>& call : calls)
                call = ordered(std::move(call));
            return calls;
        },
        row);
    return row;
}

} // namespace

CacheSubject::CacheSubject(Mesh subject, std::size_t levelCount,
                           const ArrangementSettings& arrangementSettings)
    : mesh(std::move(subject)), settings(arrangementSettings)
{
    sequence = simplify(mesh);
    const std::size_t last = sequence.steps.empty() ? 0 : sequence.steps.size() - 1;
    for (std::size_t i = 0; i < levelCount; ++i)
        levels.push_back(static_cast<std::uint32_t>(last * i / levelCount));
}

std::vector<std::string> cacheOrderNames()
{
    std::vector<std::string> names{kRandom};
    for (const NamedArrangement& named : kArrangements)
        names.push_back(named.name);
    names.push_back(kCompaction);
    names.push_back(kScratch);
    return names;
}

Json cacheRow(const CacheSubject& subject, const std::string& order)
{
    for (const NamedArrangement& named : kArrangements)
        if (order == named.name) return arrangementRow(subject, named);
    if (order == kCompaction) return compactionRow(subject);
    if (order == kRandom)
        return freshRow(subject, kRandom,
                        [random = std::mt19937(1)](std::vector<Triangle> triangles) mutable
                        {
                            std::shuffle(triangles.begin(), triangles.end(), random);
                            return triangles;
                        });
    return freshRow(subject, kScratch,
                    [&](std::vector<Triangle> triangles)
                    {
                        const auto wedges = static_cast<std::uint32_t>(subject.mesh.wedgeCount());
                        return inOrder(triangles, libraryOrder(triangles, wedges));
                    });
}

} // namespace pmtool
