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
            if (!isInTheWay(own, claim, other, theirs)) continue;
            if (!isInKnot || other.standsS <= kKnotS) return number;
            // Before the junction it will ask again; in it, it stands until others of the ring have gone.
            if (theirs.frontM <= 0.0) theirs.isHeld = false;
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

const LaneConflict* JunctionKeeper::conflictOf(const JunctionClaim& claim, const JunctionClaim& theirs)
{
    if (claim.junction >= 0 && theirs.junction == claim.junction)
        return _table.conflict(claim.lane, theirs.lane);
    if (!claim.met) return nullptr;
    const auto& met = *claim.met;
    const auto found =
        std::lower_bound(met.begin(), met.end(), theirs.lane,
                         [](const auto& entry, const JunctionLane& lane) { return entry.first < lane; });
    if (found == met.end() || found->first != theirs.lane) return nullptr;
    // Of several places where both lanes meet the one that both claims are about.
    const auto isOf = [](const JunctionClaim& one, double fromM, double toM)
    {
        constexpr double kFrontM = 4.0; // a claim begins where the front of the vehicle comes to it
        return toM > one.onLaneM - kFrontM && fromM < one.onLaneM + one.toM - one.fromM;
    };
    for (const LaneConflict& conflict : found->second)
        if (isOf(claim, conflict.ownFromM, conflict.ownToM) &&
            isOf(theirs, conflict.otherFromM, conflict.otherToM))
            return &conflict;
    return nullptr;
}

bool JunctionKeeper::isInTheWay(const JunctionApproach& own, const JunctionClaim& claim,
                                const JunctionApproach& other, const JunctionClaim& theirs)
{
    constexpr double kMarginS = 1.0, kStandsS = 1.0;
    constexpr double kAxleM = 3.5; ///< from the front of a car to its rear axle
    const LaneConflict* const conflict = conflictOf(claim, theirs);
    if (!conflict) return false;
    if (theirs.isHeld) return theirs.rearM + theirs.onLaneM < conflict->otherToM;
    if (theirs.isBehindRed) return false;
    const bool ownInside = own.standsS > kStandsS && own.isInside();
    const bool otherInside = other.standsS > kStandsS && other.isInside() && theirs.isAsked;
    if (ownInside != otherInside) return otherInside && other.hasRoomBehind;
    const bool waitsLong = other.standsS > kPatienceS && theirs.isAsked && other.hasRoomBehind;
    if (own.standsS > kPatienceS && (!waitsLong || own.standsS >= other.standsS)) return false;
    if (waitsLong) return true;
    if (claim.isNarrow || theirs.isNarrow) return false; // no rule says who goes first
    // Who has no light gives way to those who have one.
    const bool goesBefore = claim.isAtLight == theirs.isAtLight
                                ? _table.goesBefore(theirs.lane, claim.lane, claim.isAtLight)
                                : theirs.isAtLight;
    if (other.standsS > kStandsS || !goesBefore) return false;
    const double theirS = (conflict->otherFromM - theirs.frontM - theirs.onLaneM + kAxleM) /
                          std::max(other.speedMps + 1.0, 2.0);
    return theirS < secondsFor(conflict->ownToM - claim.rearM - claim.onLaneM, own.speedMps) + kMarginS;
}

} // namespace simulation
