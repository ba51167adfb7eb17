// SPDX-License-Identifier: Apache-2.0
// Knots are the circular wait of Coffman, Elphick and Shoshani, "System Deadlocks", ACM Computing Surveys 3,
// 1971; here one of the ring is given what no other one of it holds by standing there.
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

bool JunctionApproach::isInside() const
{
    constexpr double kInM = 0.5;
    return std::any_of(claims.begin(), claims.end(),
                       [](const JunctionClaim& claim) { return claim.frontM > kInM; });
}

void JunctionKeeper::setTime(double timeS)
{
    constexpr double kForgetsS = 0.5;
    if (timeS == _timeS) return;
    _timeS = timeS;
    std::erase_if(_approaches, [&](const auto& of) { return of.second.seenS < timeS - kForgetsS; });
}

int JunctionKeeper::inTheWay(int vehicle, const JunctionClaim& claim, bool isInKnot)
{
    const JunctionApproach& own = _approaches.at(vehicle);
    for (auto& [number, other] : _approaches)
    {
        if (number == vehicle) continue;
        for (JunctionClaim& theirs : other.claims)
        {
            if (_table.junctionOf(theirs.lane.road) != _table.junctionOf(claim.lane.road) ||
                !isInTheWay(own, claim, other, theirs))
                continue;
            if (!isInKnot || theirs.frontM > 0.0 || other.standsS <= kKnotS) return number;
            theirs.isHeld = false; // it stands before the junction, and will ask again
        }
    }
    return -1;
}

bool JunctionKeeper::isInKnot(int vehicle) const
{
    auto at = _approaches.find(vehicle);
    for (std::size_t steps = 0; steps <= _approaches.size(); ++steps)
    {
        if (at == _approaches.end() || at->second.standsS <= kKnotS) return false;
        at = _approaches.find(at->second.waitsFor);
        if (at != _approaches.end() && at->first == vehicle) return true;
    }
    return false;
}

bool JunctionKeeper::isInTheWay(const JunctionApproach& own, const JunctionClaim& claim,
                                const JunctionApproach& other, const JunctionClaim& theirs)
{
    constexpr double kMarginS = 1.0, kStandsS = 1.0, kAtLineM = 6.0;
    constexpr double kNextM = 10.0; ///< to a junction that belongs to the one in which it stands
    constexpr double kAxleM = 3.5;  ///< from the front of a car to its rear axle
    const LaneConflict* const conflict = _table.conflict(claim.lane, theirs.lane);
    if (!conflict) return false;
    if (theirs.isHeld) return theirs.rearM < conflict->otherToM;
    if (theirs.isBehindRed) return false;
    const bool ownInside = own.standsS > kStandsS && own.isInside();
    const bool otherInside = other.standsS > kStandsS && other.isInside() && theirs.frontM > -kNextM;
    if (ownInside != otherInside) return otherInside && other.hasRoomBehind;
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
