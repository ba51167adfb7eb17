// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "measurement/HtmlPage.h"
#include "terraintool/compare/Verdicts.h"

namespace terraintool
{

namespace
{

using measurement::figureText;

using Figures = std::function<void(const DemComparison& dem, std::vector<double>& figures)>;

/// Confirms a claim when all its figures lie in [least, most]; without a figure it is not measured.
ClaimVerdict judge(const std::string& claim, const std::string& unit, const std::vector<DemComparison>& dems,
                   double least, double most, const Figures& figuresOf)
{
    std::vector<double> figures;
    for (const DemComparison& dem : dems)
        figuresOf(dem, figures);
    if (figures.empty()) return {claim, "not measured", "no figure"};
    const auto [lowest, highest] = std::minmax_element(figures.begin(), figures.end());
    const bool holds = *lowest >= least && *highest <= most;
    const std::string range =
        *lowest == *highest ? figureText(*lowest) : figureText(*lowest) + " to " + figureText(*highest);
    return {claim, holds ? "confirmed" : "refuted", range + unit};
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

void bulkToSingle(const DemComparison& dem, std::vector<double>& figures)
{
    if (dem.merges.bulkNs > 0.0 && dem.merges.singleNs > 0.0)
        figures.push_back(dem.merges.bulkNs / dem.merges.singleNs);
}

} // namespace

std::vector<ClaimVerdict> claimVerdicts(const std::vector<DemComparison>& dems)
{
    constexpr double kNoLimit = std::numeric_limits<double>::infinity();
    return {
        judge("VDPM needs 50 to 70 % fewer triangles than ROAM", " % fewer", dems, 50.0, 70.0, fewerThanRoam),
        judge("no more than 5 % of ROAM's mesh changes in a frame", " % of the triangles", dems, 0.0, 5.0,
              changedOfRoam),
        judge("methods of blocks are more redundant than ROAM", " times ROAM's triangles", dems,
              std::nextafter(1.0, 2.0), kNoLimit, blocksToRoam),
        judge("enhMerge is quicker than merges one by one", " times their time for a triangle", dems, 0.0,
              std::nextafter(1.0, 0.0), bulkToSingle)};
}

} // namespace terraintool
