// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/StreetHeights.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "worldmaking/streets/CloseStreets.h"
#include "worldmaking/streets/HeightBounds.h"
#include "worldmaking/streets/HeightFitter.h"
#include "worldmaking/streets/LaneLayout.h"

namespace worldmaking
{

namespace
{

constexpr double kMostMissingM = 0.4; ///< of what is wanted, without a word
constexpr double kRoofSlackM = 0.4;   ///< of a wanted cover, likewise: the crown is as much lower

std::vector<double> halfWidthsOf(const StreetGraph& graph)
{
    std::vector<double> halfM;
    for (const StreetChain& chain : graph.chains)
        halfM.push_back(layoutOf(graph.traitsAt(chain, 0)).halfWidthM());
    return halfM;
}

/// Crossings as nodes.
FitLimits limitsOf(const HeightNodes& nodes, const std::vector<ChainCut>& cuts, const Crossings& crossings)
{
    const auto nodesAt = [&](std::size_t chain, double alongM)
    {
        auto found = nodes.rows[chain].around(alongM - cuts[chain].startM);
        for (std::size_t& node : found)
            node += nodes.rows[chain].first;
        return found;
    };
    const auto nodeAt = [&](std::size_t chain, double alongM)
    {
        const HeightRow& row = nodes.rows[chain];
        return row.around(std::round((alongM - cuts[chain].startM) / row.stepM) * row.stepM)[0] + row.first;
    };
    FitLimits limits;
    for (const Overpass& pass : crossings.overpasses)
        limits.overpasses.push_back({nodesAt(pass.lower, pass.lowerM), nodesAt(pass.upper, pass.upperM),
                                     pass.riseM, limits.overpasses.size()});
    for (const Overpass& pass : crossings.footLevels)
        limits.overpasses.push_back({nodesAt(pass.lower, pass.lowerM), nodesAt(pass.upper, pass.upperM),
                                     pass.riseM, limits.overpasses.size()});
    for (const LevelPlace& level : crossings.levels)
        limits.levels.push_back({nodeAt(level.street, level.streetM), nodeAt(level.track, level.trackM)});
    return limits;
}

/// Finds what the heights lack of what was wanted.
class Shortfalls
{
public:
    Shortfalls(const HeightNodes& nodes, const std::vector<ChainCut>& cuts,
               const foundation::HeightInPlan& ground, StreetHeights& heights)
        : _nodes(nodes), _cuts(cuts), _ground(ground), _heights(heights)
    {
    }

    void lookAt(std::span<const DugTunnel> tunnels)
    {
        for (const DugTunnel& tunnel : tunnels)
        {
            const HeightRow& row = _nodes.rows[tunnel.row];
            BareTunnel worst{tunnel.row};
            for (std::size_t k = tunnel.first; k <= tunnel.last; ++k)
            {
                const double sM = static_cast<double>(k) * row.stepM;
                const auto groundM = row.isTunnel[k] != 0 ? _ground(row.points[k].position) : std::nullopt;
                if (!groundM) continue;
                const double byM = heightAt(tunnel.row, sM) + kTunnelRoofM - kRoofSlackM - *groundM;
                if (byM > worst.byM) worst = {tunnel.row, sM + _cuts[tunnel.row].startM, byM};
            }
            if (worst.byM > kMostMissingM) _heights.bareTunnels.push_back(worst);
        }
    }

    void lookAt(std::span<const CrossedPlace> crossed)
    {
        for (std::size_t i = 0; i < crossed.size(); ++i)
        {
            const CrossedPlace& place = crossed[i];
            const auto groundM = _ground(place.place);
            if (!groundM) continue;
            const double apartM = heightAt(place.chain, place.alongM - _cuts[place.chain].startM) - *groundM;
            if ((place.isStreetAbove ? apartM : -apartM) < place.apartM - kMostMissingM)
                _heights.lostCrossed.push_back(i);
        }
    }

private:
    double heightAt(std::size_t chain, double sM) const
    {
        return _heights.profiles[chain].elevation.value(std::clamp(sM, 0.0, _nodes.rows[chain].lengthM()));
    }

    const HeightNodes& _nodes;
    const std::vector<ChainCut>& _cuts;
    const foundation::HeightInPlan& _ground;
    StreetHeights& _heights;
};

} // namespace

StreetHeights heightsOf(const StreetGraph& graph, const std::vector<CentreLine>& lines,
                        const std::vector<ChainCut>& cuts, const Crossings& crossings,
                        const foundation::HeightInPlan& ground)
{
    const HeightNodes nodes = heightNodesOf(graph, lines, cuts);
    const auto ties = closeStreets(nodes, halfWidthsOf(graph));
    const auto wishesM = smoothGround(nodes, ground, ties);
    FitLimits limits = limitsOf(nodes, cuts, crossings);
    const auto tunnels = dugTunnels(nodes, wishesM, ground);
    limits.bounds = heightBoundsOf(nodes, cuts, tunnels, crossings, wishesM, ground);
    const FittedHeights fitted = fitToLimits(graph, nodes, wishesM, limits);
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
    result.lost = fitted.lost;
    std::erase_if(result.lost, [&](std::size_t pass) // what a footbridge lacks is told with it
                  { return pass >= crossings.overpasses.size(); });
    for (const LevelPlace& level : crossings.levels)
        result.levels.push_back(
            {level.track, level.trackM,
             result.profiles[level.street].elevation.value(std::clamp(
                 level.streetM - cuts[level.street].startM, 0.0, nodes.rows[level.street].lengthM()))});
    Shortfalls shortfalls(nodes, cuts, ground, result);
    shortfalls.lookAt(tunnels);
    shortfalls.lookAt(std::span<const CrossedPlace>(crossings.crossed));
    return result;
}

} // namespace worldmaking
