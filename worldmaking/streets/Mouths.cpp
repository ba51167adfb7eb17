// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/Mouths.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <foundation/Angle.h>
#include <glm/geometric.hpp>

#include "worldmaking/streets/LaneLayout.h"

namespace worldmaking
{

namespace
{

constexpr double kAheadM = 12.0;        ///< where the direction of an arm is taken
constexpr double kTurnRoomM = 3.0;      ///< beyond the place where borders meet
constexpr double kMostAngledM = 30.0;   ///< beyond, arms are looked at along their lines: these bend
constexpr double kMostMouthM = 110.0;   ///< arms that run side by side never come clear
constexpr double kMouthLookM = 2.0;     ///< between places of a line that are looked at
constexpr double kMostBendRad = 0.6;    ///< of a line within a crossing, whose turns are one bend each
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

/// How far along `arm` its border meets that of `other`, both straight.
double meetingM(const Arm& arm, const Arm& other)
{
    const double angle = std::fabs(foundation::wrappedRad(other.headingRad - arm.headingRad));
    if (angle > kAlmostStraight) return 0.0;
    const double sine = std::max(std::sin(angle), 1e-3);
    return std::max((other.halfWidthM + arm.halfWidthM * std::cos(angle)) / sine, 0.0);
}

/// The places of an arm from the crossing outwards, kMouthLookM apart, as far as it turns by less than
/// `mostBendRad`.
std::vector<glm::dvec2> mouthPlaces(const CentreLine& line, const StreetArm& arm, double mostBendRad)
{
    constexpr double kBesideM = 20.0;
    std::vector<glm::dvec2> places;
    const double mostM = std::min(kMostMouthM + kBesideM, line.lengthM());
    double turnedRad = 0.0, headingRad = 0.0;
    for (double awayM = 0.0; awayM <= mostM; awayM += kMouthLookM)
    {
        const auto point = line.at(arm.isEnd ? line.lengthM() - awayM : awayM);
        if (!places.empty()) turnedRad += std::fabs(foundation::wrappedRad(point.headingRad - headingRad));
        if (turnedRad > mostBendRad) break;
        headingRad = point.headingRad;
        places.push_back(point.position);
    }
    return places;
}

/// How far along one arm its paving is clear of that of another; nothing where it is nowhere.
std::optional<double> clearOf(const std::vector<glm::dvec2>& own, const std::vector<glm::dvec2>& others,
                              double apartM)
{
    for (std::size_t i = 0; i < own.size(); ++i)
    {
        const auto isNear = [&](const glm::dvec2& place) { return glm::distance(place, own[i]) < apartM; };
        if (std::none_of(others.begin(), others.end(), isNear)) return static_cast<double>(i) * kMouthLookM;
    }
    return std::nullopt;
}

/// How much of a chain one of its crossings may take.
double mostOf(const CentreLine& line)
{
    return std::min(kMostShare * line.lengthM(), 0.5 * (line.lengthM() - kLeastRoadM));
}

/// How far along an arm the crossing reaches for the sake of another one. Farther than kMostAngledM only
/// where both arms are long enough to come clear of each other: else it would be no use.
double mouthFor(const StreetGraph& graph, const std::vector<CentreLine>& lines, const StreetArm& arm,
                const StreetArm& other)
{
    const Arm self = armOf(graph, lines, arm), beside = armOf(graph, lines, other);
    const double angledM = meetingM(self, beside), apartM = self.halfWidthM + beside.halfWidthM;
    if (angledM <= kMostAngledM) return angledM;
    const CentreLine &line = lines[arm.chain], &othersLine = lines[other.chain];
    constexpr double kAnyRad = 1e9;
    const auto clearM = clearOf(mouthPlaces(line, arm, kMostBendRad), mouthPlaces(othersLine, other, kAnyRad),
                                apartM),
               othersM = clearOf(mouthPlaces(othersLine, other, kMostBendRad),
                                 mouthPlaces(line, arm, kAnyRad), apartM);
    const bool isUse = clearM && othersM && std::max(*clearM, *othersM) <= kMostMouthM &&
                       *clearM + kTurnRoomM <= mostOf(line) && *othersM + kTurnRoomM <= mostOf(othersLine);
    return isUse ? *clearM : kMostAngledM;
}

} // namespace

std::vector<ChainCut> mouthsOf(const StreetGraph& graph, const std::vector<CentreLine>& lines)
{
    std::vector<ChainCut> cuts(graph.chains.size());
    for (const Crossing& crossing : graph.crossings)
        for (const StreetArm& arm : crossing.arms)
        {
            double mouth = 0.0;
            for (const StreetArm& other : crossing.arms)
                if (&other != &arm) mouth = std::max(mouth, mouthFor(graph, lines, arm, other));
            const double most = mostOf(lines[arm.chain]);
            (arm.isEnd ? cuts[arm.chain].endM : cuts[arm.chain].startM) =
                std::max(0.0, std::min(mouth + kTurnRoomM, most));
        }
    return cuts;
}

} // namespace worldmaking
