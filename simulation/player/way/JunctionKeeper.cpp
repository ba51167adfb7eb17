// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/way/JunctionKeeper.h"

#include <algorithm>
#include <cmath>

namespace simulation
{

double secondsFor(double wayM, double speedMps)
{
    constexpr double kGentleMps2 = 1.0, kAcrossMps = 6.0;
    if (!(wayM > 0.0)) return 0.0;
    const double most = std::max(kAcrossMps, speedMps);
    const double end = std::min(most, std::sqrt(speedMps * speedMps + 2.0 * kGentleMps2 * wayM));
    return wayM / std::max(0.5 * (speedMps + end), 0.5);
}

bool JunctionKeeper::mayEnter(int vehicle, const JunctionClaim& claim)
{
    const JunctionApproach& own = _approaches.at(vehicle);
    for (const auto& [number, other] : _approaches)
    {
        if (number == vehicle) continue;
        for (const JunctionClaim& theirs : other.claims)
            if (_table.junctionOf(theirs.lane.road) == _table.junctionOf(claim.lane.road) &&
                isInTheWay(own, claim, other, theirs))
                return false;
    }
    return true;
}

bool JunctionKeeper::isInTheWay(const JunctionApproach& own, const JunctionClaim& claim,
                                const JunctionApproach& other, const JunctionClaim& theirs)
{
    constexpr double kMarginS = 1.0, kStandsS = 1.0, kAtLineM = 6.0;
    constexpr double kAxleM = 3.5; ///< from the front of a car to its rear axle
    const LaneConflict* const conflict = _table.conflict(claim.lane, theirs.lane);
    if (!conflict) return false;
    if (theirs.isHeld) return theirs.rearM < conflict->otherToM;
    if (theirs.isBehindRed) return false;
    const bool waitsLong = other.standsS > kPatienceS && theirs.frontM > -kAtLineM && other.hasRoomBehind;
    if (own.standsS > kPatienceS && (!waitsLong || own.standsS >= other.standsS)) return false;
    if (waitsLong) return true;
    // Who has no light gives way to those who have one.
    const bool goesBefore = claim.isAtLight == theirs.isAtLight
                                ? _table.goesBefore(theirs.lane, claim.lane, claim.isAtLight)
                                : theirs.isAtLight;
    if (other.standsS > kStandsS || !goesBefore) return false;
    const double theirS =
        (conflict->otherFromM - theirs.frontM + kAxleM) / std::max(other.speedMps + 1.0, 2.0);
    return theirS < secondsFor(conflict->ownToM - claim.rearM, own.speedMps) + kMarginS;
}

} // namespace simulation
