// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/BendRoom.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "worldmaking/streets/ConnectingRoad.h"

namespace worldmaking
{

namespace
{

using osgRoads::core::Cubic;
using osgRoads::core::CubicProfile;
using osgRoads::core::Road;

constexpr double kBendShare = 0.95; ///< of the way to the centre
constexpr double kBendStepM = 0.25; ///< between places that are looked at; pieces are as long
constexpr double kBendSlackM = 1e-6;

} // namespace

double roomInBend(const Road& road, double s)
{
    const double curvature = road.referenceLine.at(s).curvature;
    return curvature < 0.0 ? -kBendShare / curvature : std::numeric_limits<double>::infinity();
}

CubicProfile widthInBend(const Road& road, const Cubic& wish, const WidthAlong& insideM)
{
    const int count = std::max(1, static_cast<int>(std::ceil(road.length / kBendStepM)));
    const double stepM = road.length / count;
    // The least room up to the neighbours, between which the width is linear.
    const auto leastRoomM = [&](double s)
    {
        double leastM = std::numeric_limits<double>::infinity();
        for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0})
        {
            const double at = std::clamp(s + share * stepM, 0.0, road.length);
            leastM = std::min(leastM, roomInBend(road, at) - insideM(at));
        }
        return std::max(0.0, leastM);
    };
    std::vector<double> widthsM;
    bool isWish = true;
    for (int i = 0; i <= count; ++i)
    {
        const double s = i * stepM;
        const double wishM = wish.a + s * (wish.b + s * (wish.c + s * wish.d));
        const bool isEnd = i == 0 || i == count;
        const double roomM = isEnd ? wishM : leastRoomM(s);
        isWish = isWish && roomM >= wishM - kBendSlackM;
        widthsM.push_back(std::min(wishM, roomM));
    }
    if (isWish) return CubicProfile({wish});
    std::vector<Cubic> pieces;
    for (int i = 0; i < count; ++i)
    {
        const auto at = static_cast<std::size_t>(i);
        const double slope = (widthsM[at + 1] - widthsM[at]) / stepM;
        pieces.push_back(hermitePiece(i * stepM, stepM, widthsM[at], slope, widthsM[at + 1], slope));
    }
    return CubicProfile(std::move(pieces));
}

} // namespace worldmaking
