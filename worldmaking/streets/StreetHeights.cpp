// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/StreetHeights.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "worldmaking/streets/CloseStreets.h"
#include "worldmaking/streets/HeightFitter.h"
#include "worldmaking/streets/LaneLayout.h"

namespace worldmaking
{

namespace
{

/// The nodes before and after a place of a road.
std::array<std::size_t, 2> nodesAround(const HeightRow& row, double alongM)
{
    const double most = static_cast<double>(row.last());
    const auto at = [&](double node)
    { return row.first + static_cast<std::size_t>(std::clamp(node, 0.0, most)); };
    const double place = alongM / row.stepM;
    return {at(std::floor(place)), at(std::ceil(place))};
}

std::vector<double> halfWidthsOf(const StreetGraph& graph)
{
    std::vector<double> halfM;
    for (const StreetChain& chain : graph.chains)
        halfM.push_back(layoutOf(graph.traitsAt(chain, 0)).halfWidthM());
    return halfM;
}

std::vector<OverpassNodes> overpassNodes(const HeightNodes& nodes, const std::vector<ChainCut>& cuts,
                                         const std::vector<Overpass>& overpasses)
{
    const auto nodesAt = [&](std::size_t chain, double alongM)
    { return nodesAround(nodes.rows[chain], alongM - cuts[chain].startM); };
    std::vector<OverpassNodes> passes;
    for (const Overpass& pass : overpasses)
        passes.push_back({nodesAt(pass.lower, pass.lowerM), nodesAt(pass.upper, pass.upperM)});
    return passes;
}

} // namespace

StreetHeights heightsOf(const StreetGraph& graph, const std::vector<CentreLine>& lines,
                        const std::vector<ChainCut>& cuts, const std::vector<Overpass>& overpasses,
                        const GroundHeight& ground)
{
    const HeightNodes nodes = heightNodesOf(graph, lines, cuts);
    const auto ties = closeStreets(nodes, halfWidthsOf(graph));
    const FittedHeights fitted =
        fitToLimits(graph, nodes, smoothGround(nodes, ground, ties), overpassNodes(nodes, cuts, overpasses));
    const auto planeAt = [&](int crossing)
    {
        const auto area = nodes.areaAt(crossing);
        return area ? &fitted.planes[*area] : nullptr;
    };
    StreetHeights result;
    for (std::size_t i = 0; i < nodes.rows.size(); ++i)
    {
        const HeightRow& row = nodes.rows[i];
        const auto first = fitted.heightsM.begin() + static_cast<std::ptrdiff_t>(row.first);
        result.profiles.push_back(
            profileOf(row, {first, first + static_cast<std::ptrdiff_t>(row.points.size())},
                      {planeAt(graph.chains[i].startCrossing), planeAt(graph.chains[i].endCrossing)}));
    }
    for (const int area : nodes.areaOf)
        result.planes.push_back(fitted.planes[static_cast<std::size_t>(area)]);
    result.lostOverpasses = fitted.lostOverpasses;
    return result;
}

} // namespace worldmaking
