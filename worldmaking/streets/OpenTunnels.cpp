// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/OpenTunnels.h"

#include <algorithm>
#include <utility>

#include "worldmaking/streets/Overpass.h"

namespace worldmaking
{

namespace
{

constexpr double kMostBareM = 0.8; ///< of the wanted cover, without a word

/// A tunnel of a chain: its pieces, and where it lies along the chain.
struct TunnelRun
{
    std::size_t first = 0, end = 0; ///< pieces
    double fromM = 0.0, toM = 0.0;
};

std::vector<TunnelRun> tunnelsOf(const StreetGraph& graph, const StreetChain& chain, const CentreLine& line)
{
    const auto isTunnel = [&](std::size_t piece)
    { return graph.traitsAt(chain, piece).place == StreetPlace::tunnel; };
    std::vector<TunnelRun> runs;
    for (std::size_t piece = 0; piece < chain.pieces.size(); ++piece)
    {
        if (!isTunnel(piece)) continue;
        if (runs.empty() || runs.back().end < piece) runs.push_back({piece, piece, line.pointsM()[piece]});
        runs.back().end = piece + 1;
        runs.back().toM = line.pointsM()[piece + 1];
    }
    return runs;
}

/// Whether the roof of a tunnel stands above the ground in its middle.
bool isBare(const TunnelRun& run, std::size_t chain, const KnownWays& ways,
            const foundation::HeightInPlan& ground)
{
    const double alongM = 0.5 * (run.fromM + run.toM);
    const double roadM = ways.lines[chain].lengthM() - ways.cuts[chain].startM - ways.cuts[chain].endM;
    const double s = std::clamp(alongM - ways.cuts[chain].startM, 0.0, roadM);
    const auto groundM = ground(ways.lines[chain].at(alongM).position);
    return groundM && ways.heights.profiles[chain].elevation.value(s) + kTunnelRoofM - kMostBareM > *groundM;
}

/// Whether something passes over a tunnel, or it over something.
bool isCrossed(const Crossings& crossings, std::size_t chain, const TunnelRun& run)
{
    const auto isWithin = [&](std::size_t other, double alongM)
    { return other == chain && alongM >= run.fromM && alongM <= run.toM; };
    const auto isPassed = [&](const Overpass& pass)
    { return isWithin(pass.lower, pass.lowerM) || isWithin(pass.upper, pass.upperM); };
    const auto any = [&](const std::vector<Overpass>& passes)
    { return std::any_of(passes.begin(), passes.end(), isPassed); };
    return any(crossings.overpasses) || any(crossings.leftOpen) || any(crossings.footLevels) ||
           std::any_of(crossings.crossed.begin(), crossings.crossed.end(),
                       [&](const CrossedPlace& place) { return isWithin(place.chain, place.alongM); });
}

} // namespace

std::size_t openBareTunnels(StreetGraph& graph, const KnownWays& ways, const foundation::HeightInPlan& ground)
{
    std::size_t opened = 0;
    for (std::size_t i = 0; i < graph.chains.size(); ++i)
        for (const TunnelRun& run : tunnelsOf(graph, graph.chains[i], ways.lines[i]))
        {
            if (run.toM - run.fromM > kShortTunnelM || isCrossed(ways.crossings, i, run) ||
                !isBare(run, i, ways, ground))
                continue;
            for (std::size_t piece = run.first; piece < run.end; ++piece)
            {
                StreetTraits traits = graph.traitsAt(graph.chains[i], piece);
                traits.place = StreetPlace::ground;
                graph.chains[i].pieces[piece].traits = graph.traits.size(); // the way may have other tunnels
                graph.traits.push_back(std::move(traits));
            }
            ++opened;
        }
    return opened;
}

} // namespace worldmaking
