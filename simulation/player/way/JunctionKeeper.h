// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "simulation/road/JunctionTable.h"

namespace simulation
{

/// What a vehicle that keeps the rules wants of a junction ahead, or has of one under it.
struct JunctionClaim
{
    JunctionLane lane;
    double fromM = 0.0;               ///< where the lane begins, along the vehicle's way
    double frontM = 0.0, rearM = 0.0; ///< of the vehicle, from there; negative: before it
    bool isHeld = false;              ///< it drives, or has been let in
    bool isAtLight = false;           ///< a traffic light that is on stands before it
    bool isBehindRed = false;         ///< and it has to stop there, or at an earlier one
};

/// A vehicle on its way to junctions, as others know it. Units: metres, m/s, seconds.
struct JunctionApproach
{
    std::vector<JunctionClaim> claims; ///< in the order in which it comes to them
    double lengthM = 0.0;
    double speedMps = 0.0;
    double standsS = 0.0;      ///< since it has come to a stand
    bool hasRoomBehind = true; ///< to leave the first junction that it does not hold
};

/// Who may drive into junctions: whoever goes before by the rules, nobody into what another one needs who is
/// let in. Who has stood for long goes before the others who have not been let in.
/// Determinism: vehicles ask in the order of their entities. Threads: one.
class JunctionKeeper
{
public:
    static constexpr double kPatienceS = 15.0;

    explicit JunctionKeeper(const RoadScene& roads) : _table(roads) {}

    JunctionTable& table() { return _table; }

    /// Of a vehicle, which keeps the rules from now on.
    JunctionApproach& of(int vehicle) { return _approaches[vehicle]; }
    void leave(int vehicle) { _approaches.erase(vehicle); }
    bool isKept(int vehicle) const { return _approaches.contains(vehicle); }

    /// Whether a vehicle may take the lane of one of its claims now, for all that other vehicles of the
    /// keeper do.
    bool mayEnter(int vehicle, const JunctionClaim& claim);

private:
    bool isInTheWay(const JunctionApproach& own, const JunctionClaim& claim, const JunctionApproach& other,
                    const JunctionClaim& theirs);

    JunctionTable _table;
    std::map<int, JunctionApproach> _approaches;
};

/// The seconds that a vehicle needs for a way, when it goes on gently from its speed.
double secondsFor(double wayM, double speedMps);

} // namespace simulation
