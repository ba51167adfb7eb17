// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "compare/terrain/methods/JudgedFigures.h"
#include "compare/terrain/methods/Verdicts.h"

namespace terraintool
{

namespace
{

using Figures = std::function<void(const DemComparison& dem, std::vector<double>& figures)>;

/// Judges a claim by the figures of all terrains.
ClaimVerdict judge(const std::string& claim, const std::string& unit, const std::vector<DemComparison>& dems,
                   HeldRange holds, const Figures& figuresOf)
{
    std::vector<double> figures;
    for (const DemComparison& dem : dems)
        figuresOf(dem, figures);
    auto [verdict, figure] = judgeFigures(figures, holds, unit);
    return {claim, std::move(verdict), std::move(figure)};
}

void fewerThanRoam(const DemComparison& dem, std::vector<double>& figures)
{
    const MethodFigures *vdpm = dem.of("vdpm"), *roam = dem.of("roam");
    if (vdpm && roam) figures.push_back(100.0 * (1.0 - vdpm->triangles / roam->triangles));
}

void changedOfRoam(const DemComparison& dem, std::vector<double>& figures)
{
    if (const MethodFigures* roam = dem.of("roam")) figures.push_back(roam->changedPercent);
}

void blocksToRoam(const DemComparison& dem, std::vector<double>& figures)
{
    const MethodFigures* roam = dem.of("roam");
    for (const MethodFigures& m : dem.methods)
        if (roam && m.isOfBlocks) figures.push_back(m.triangles / roam->triangles);
}

void overlappingToLocked(const DemComparison& dem, std::vector<double>& figures)
{
    const MethodFigures *overlapping = dem.of("vipm-overlapping"), *locked = dem.of("vipm-locked");
    if (overlapping && locked) figures.push_back(overlapping->triangles / locked->triangles);
}

void bulkToSingle(const DemComparison& dem, std::vector<double>& figures)
{
    if (dem.merges.bulkNs > 0.0 && dem.merges.singleNs > 0.0)
        figures.push_back(dem.merges.bulkNs / dem.merges.singleNs);
}

/// Compares two ways along all paths that were measured with refinement all around, or in sight alone.
Figures reworkRatio(const char* way, const char* other, bool inSight)
{
    return [=](const DemComparison& dem, std::vector<double>& figures)
    {
        for (const ReworkFigures& rework : dem.reworks)
            if (const auto otherUs = dem.reworkUs(rework.path, other);
                rework.way == way && rework.inSight == inSight && otherUs)
                figures.push_back(rework.adaptUsP50 / *otherUs);
    };
}

/// The share of a method's time that a fit ascribes to the size of its mesh or to what changes.
Figures shareOfTime(const char* method, double FitFigures::*share)
{
    return [=](const DemComparison& dem, std::vector<double>& figures)
    {
        const MethodFigures* m = dem.of(method);
        if (m && m->fit && m->fit->sizePercent + m->fit->changePercent > 0.0)
            figures.push_back(m->fit.value().*share);
    };
}

/// How much dearer morphing makes regular decimation's frames than it makes ROAM's, by time and by vertices
/// written.
void morphingOfBlocks(const DemComparison& dem, std::vector<double>& figures)
{
    const MethodFigures *blocks = dem.of("regular-decimation"), *roam = dem.of("roam");
    if (!blocks || !roam || !blocks->morph || !roam->morph || roam->morph->vertices <= 0.0) return;
    figures.push_back(blocks->morph->vertices / roam->morph->vertices);
}

void lightOfBlocks(const DemComparison& dem, std::vector<double>& figures)
{
    const MethodFigures *blocks = dem.of("regular-decimation"), *roam = dem.of("roam");
    if (blocks && roam && roam->lightDeg > 0.0) figures.push_back(blocks->lightDeg / roam->lightDeg);
}

} // namespace

std::vector<ClaimVerdict> claimVerdicts(const std::vector<DemComparison>& dems)
{
    constexpr double kNoLimit = std::numeric_limits<double>::infinity(), kHalf = 50.0;
    const HeldRange more{std::nextafter(1.0, 2.0), kNoLimit}, less{0.0, std::nextafter(1.0, 0.0)};
    return {
        judge("VDPM needs 50 to 70 % fewer triangles than ROAM", " % fewer", dems, {50.0, 70.0},
              fewerThanRoam),
        judge("no more than 5 % of ROAM's mesh changes in a frame", " % of the triangles", dems, {0.0, 5.0},
              changedOfRoam),
        judge("methods of blocks are more redundant than ROAM", " times ROAM's triangles", dems, more,
              blocksToRoam),
        judge("enhMerge is quicker than merges one by one", " times their time for a triangle", dems, less,
              bulkToSingle),
        judge("enhMerge is quicker than merges one by one in frames that have little in common (the paper's "
              "loop, refined in sight as there)",
              " times the time of the same walk", dems, less, reworkRatio("enhMerge", "one by one", true)),
        judge("enhMerge is quicker than merges one by one in frames that have little in common (the paper's "
              "loop, refined all around)",
              " times the time of the same walk", dems, less, reworkRatio("enhMerge", "one by one", false)),
        judge("with enhMerge such frames need no restart (the paper's loop, refined in sight as there)",
              " times the time of a restart", dems, less, reworkRatio("enhMerge", "restart", true)),
        judge("with enhMerge such frames need no restart (the paper's loop, refined all around)",
              " times the time of a restart", dems, less, reworkRatio("enhMerge", "restart", false)),
        judge("such frames need no restart (the wheel, in use, refined in sight)",
              " times the time of a restart", dems, less, reworkRatio("wheel", "restart", true)),
        judge("such frames need no restart (the wheel, in use, refined all around)",
              " times the time of a restart", dems, less, reworkRatio("wheel", "restart", false)),
        judge("ROAM's time follows what changes (the wheel, in use)", " % of what is not constant", dems,
              {kHalf, 100.0}, shareOfTime("roam", &FitFigures::changePercent)),
        judge("ROAM's time follows what changes (the paper's loop)", " % of what is not constant", dems,
              {kHalf, 100.0}, shareOfTime("roam-walk", &FitFigures::changePercent)),
        judge("ROAM's time follows what changes (two queues)", " % of what is not constant", dems,
              {kHalf, 100.0}, shareOfTime("roam-queue", &FitFigures::changePercent)),
        judge("VIPM's time follows what changes (locked borders)", " % of what is not constant", dems,
              {kHalf, 100.0}, shareOfTime("vipm-locked", &FitFigures::changePercent)),
        judge("VIPM's time follows what changes (overlapping)", " % of what is not constant", dems,
              {kHalf, 100.0}, shareOfTime("vipm-overlapping", &FitFigures::changePercent)),
        judge("blocks that overlap need fewer triangles than locked ones", " times their triangles", dems,
              less, overlappingToLocked),
        judge("VDPM's time follows the size of its mesh", " % of what is not constant", dems, {kHalf, 100.0},
              shareOfTime("vdpm", &FitFigures::sizePercent)),
        judge("morphing whole blocks takes more than ROAM's morphing", " times the vertices written", dems,
              more, morphingOfBlocks),
        judge("light jumps more with regular decimation than with ROAM",
              " times the largest turn of a normal", dems, more, lightOfBlocks)};
}

} // namespace terraintool
