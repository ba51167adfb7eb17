// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/SharedPaving.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "worldmaking/streets/LaneLayout.h"

namespace worldmaking
{

namespace
{

constexpr double kSampleM = 2.0; ///< between places that are looked at
constexpr double kBesideM = 0.5; ///< between pavings that count as one
constexpr double kLookM = 70.0;  ///< along the other arms

/// An arm as samples of its line, from the crossing outwards.
struct SampledArm
{
    std::vector<glm::dvec2> places;
    double halfM = 0.0;

    bool isNear(const glm::dvec2& place, double beyondM) const
    {
        const double reachM = halfM + beyondM;
        return std::any_of(places.begin(), places.end(),
                           [&](const glm::dvec2& own)
                           { return glm::dot(own - place, own - place) < reachM * reachM; });
    }
};

SampledArm sampledArm(const StreetGraph& graph, const std::vector<CentreLine>& lines, const StreetArm& arm)
{
    const CentreLine& line = lines[arm.chain];
    const StreetChain& chain = graph.chains[arm.chain];
    SampledArm sampled;
    sampled.halfM = layoutOf(graph.traitsAt(chain, arm.isEnd ? chain.pieces.size() - 1 : 0)).halfWidthM();
    const double mostM = std::min(kLookM, line.lengthM());
    for (double s = 0.0; s <= mostM; s += kSampleM)
        sampled.places.push_back(line.at(arm.isEnd ? line.lengthM() - s : s).position);
    return sampled;
}

} // namespace

std::vector<ChainCut> sharedPaving(const StreetGraph& graph, const std::vector<CentreLine>& lines,
                                   const std::vector<ChainCut>& mouths)
{
    std::vector<ChainCut> shared(graph.chains.size());
    for (const Crossing& crossing : graph.crossings)
    {
        if (crossing.arms.empty() || graph.traitsAt(graph.chains[crossing.arms.front().chain], 0).isTrack)
            continue;
        std::vector<SampledArm> arms;
        for (const StreetArm& arm : crossing.arms)
            arms.push_back(sampledArm(graph, lines, arm));
        for (std::size_t i = 0; i < arms.size(); ++i)
        {
            const StreetArm& arm = crossing.arms[i];
            const ChainCut& cut = mouths[arm.chain];
            const double mouthM = arm.isEnd ? cut.endM : cut.startM;
            const double roadM = lines[arm.chain].lengthM() - cut.startM - cut.endM;
            const double mostM = mouthM + std::min(kMostSharedM, 0.5 * roadM);
            double s = mouthM;
            const auto isShared = [&](const glm::dvec2& place)
            {
                for (std::size_t j = 0; j < arms.size(); ++j)
                    if (j != i && arms[j].isNear(place, arms[i].halfM + kBesideM)) return true;
                return false;
            };
            const CentreLine& line = lines[arm.chain];
            while (s < mostM && isShared(line.at(arm.isEnd ? line.lengthM() - s : s).position))
                s += kSampleM;
            (arm.isEnd ? shared[arm.chain].endM : shared[arm.chain].startM) =
                std::clamp(s, mouthM, mostM) - mouthM;
        }
    }
    return shared;
}

} // namespace worldmaking
