// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "simulation/road/JunctionTable.h"

namespace simulation
{

/// What a vehicle that keeps the rules wants of a junction ahead, or has of one under it: a lane through it;
/// or of a narrow stretch of a lane elsewhere.
struct JunctionClaim
{
    JunctionLane lane;
    double fromM = 0.0;                                  ///< where it begins, along the vehicle's way
    double frontM = 0.0, rearM = 0.0;                    ///< of the vehicle, from there; negative: before it
    bool isHeld = false;                                 ///< it drives, or has been let in
    double toM = 1e300;                                  ///< where it ends, along the vehicle's way
    double onLaneM = 0.0;                                ///< where it begins, along its lane
    bool isNarrow = false;                               ///< a stretch elsewhere
    int junction = -1;                                   ///< its index; -1: none
    const std::vector<LaneMeetings::Met>* met = nullptr; ///< the lanes that the lane meets; null: none
    bool isAsked = false;     ///< it is before the vehicle, or has to be passed together with that
    bool isAtLight = false;   ///< a traffic light that is on stands before it
    bool isBehindRed = false; ///< and it has to stop there, or at an earlier one
};

/// A vehicle on its way to junctions, as others know it. Units: metres, m/s, seconds.
struct JunctionApproach
{
    std::vector<JunctionClaim> claims; ///< in the order in which it comes to them
    double lengthM = 0.0;
    double speedMps = 0.0;
    double standsS = 0.0;      ///< since it has come to a stand
    bool hasRoomBehind = true; ///< to leave the first junction that it does not hold
    int waitsFor = -1;         ///< the entity for which it stands; -1: none
    double seenS = 0.0;        ///< when it looked last

    /// Whether a part of it is in a junction.
    bool isInside() const;
};

/// Who may drive into junctions: whoever goes before by the rules, nobody into what another one needs who is
/// let in. Who stands in one junction goes before those who are in none; who has stood for long before the
/// others who have not been let in; and of several who wait for each other in a ring one goes all the same.
/// Determinism: vehicles ask in the order of their entities. Threads: one.
class JunctionKeeper
{
public:
    static constexpr double kPatienceS = 15.0;
    static constexpr double kKnotS = 4.0; ///< in which all of a ring have stood before one goes

    explicit JunctionKeeper(const RoadScene& roads) : _table(roads) {}

    JunctionTable& table() { return _table; }

    /// Of a vehicle, which keeps the rules from now on.
    JunctionApproach& of(int vehicle) { return _approaches[vehicle]; }
    void leave(int vehicle) { _approaches.erase(vehicle); }

    /// Tells the time of the step. Who has not looked for a while, because it was taken out or a person
    /// drives it, keeps the rules no longer.
    void setTime(double timeS);
    bool isKept(int vehicle) const { return _approaches.contains(vehicle); }

    /// Returns who is in the way of a vehicle that wants to take the lane of one of its claims now, of the
    /// vehicles of the keeper; -1: it may. `isInKnot`: of several who wait for each other it is the one to
    /// go, and those lose their claims who stand before the junction.
    int inTheWay(int vehicle, const JunctionClaim& claim, bool isInKnot = false);

    /// Whether a vehicle waits for others who, all of them standing, wait for it.
    bool isInKnot(int vehicle) const;

private:
    /// Where the lanes of two claims meet, if they do.
    const LaneConflict* conflictOf(const JunctionClaim& claim, const JunctionClaim& theirs);
    bool isInTheWay(const JunctionApproach& own, const JunctionClaim& claim, const JunctionApproach& other,
                    const JunctionClaim& theirs);

    JunctionTable _table;
    std::map<int, JunctionApproach> _approaches;
    double _timeS = -1.0;
};

/// The seconds that a vehicle needs for a way, when it goes on gently from its speed.
double secondsFor(double wayM, double speedMps);

} // namespace simulation
