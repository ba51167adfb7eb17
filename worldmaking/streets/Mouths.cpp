// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/Mouths.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

#include "worldmaking/streets/LaneLayout.h"

namespace worldmaking
{

namespace
{

constexpr double kAheadM = 12.0;        ///< where the direction of an arm is taken
constexpr double kTurnRoomM = 3.0;      ///< beyond the place where borders meet
constexpr double kMostMouthM = 30.0;    ///< arms that run side by side never come clear
constexpr double kAlmostStraight = 2.8; ///< radians: such arms do not meet at their sides
constexpr double kMostShare = 0.4;      ///< of a chain, for each of its ends

struct Arm
{
    double headingRad = 0.0; ///< away from the crossing
    double halfWidthM = 0.0;
};

Arm armOf(const StreetGraph& graph, const std::vector<CentreLine>& lines, const StreetArm& arm)
{
    const CentreLine& line = lines[arm.chain];
    const StreetChain& chain = graph.chains[arm.chain];
    const double ahead = std::min(kAheadM, 0.5 * line.lengthM());
    const glm::dvec2 from = line.at(arm.isEnd ? line.lengthM() : 0.0).position;
    const glm::dvec2 way = line.at(arm.isEnd ? line.lengthM() - ahead : ahead).position - from;
    const std::size_t piece = arm.isEnd ? chain.pieces.size() - 1 : 0;
    return {std::atan2(way.y, way.x), layoutOf(graph.traitsAt(chain, piece)).halfWidthM()};
}

/// How far along `arm` its border meets that of `other`.
double meetingM(const Arm& arm, const Arm& other)
{
    const double angle = std::fabs(foundation::wrappedRad(other.headingRad - arm.headingRad));
    if (angle > kAlmostStraight) return 0.0;
    const double sine = std::max(std::sin(angle), 1e-3);
    return std::clamp((other.halfWidthM + arm.halfWidthM * std::cos(angle)) / sine, 0.0, kMostMouthM);
}

} // namespace

std::vector<ChainCut> mouthsOf(const StreetGraph& graph, const std::vector<CentreLine>& lines)
{
    std::vector<ChainCut> cuts(graph.chains.size());
    for (const Crossing& crossing : graph.crossings)
        for (const StreetArm& arm : crossing.arms)
        {
            double mouth = 0.0;
            const Arm self = armOf(graph, lines, arm);
            for (const StreetArm& other : crossing.arms)
                if (&other != &arm) mouth = std::max(mouth, meetingM(self, armOf(graph, lines, other)));
            const double length = lines[arm.chain].lengthM();
            const double most = std::min(kMostShare * length, 0.5 * (length - kLeastRoadM));
            (arm.isEnd ? cuts[arm.chain].endM : cuts[arm.chain].startM) =
                std::max(0.0, std::min(mouth + kTurnRoomM, most));
        }
    return cuts;
}

} // namespace worldmaking
