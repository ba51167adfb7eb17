// SPDX-License-Identifier: Apache-2.0
// Differs from the models of gap acceptance of the literature: who is let in has the junction's lanes that
// cross its own for itself until it has left them, so that no two can meet there, whatever they do.
#include "simulation/player/way/WayDriver.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>
#include <glm/geometric.hpp>

#include "simulation/player/EntityBox.h"
#include "simulation/road/StopAtSign.h"
#include "simulation/road/StopSignals.h"

namespace simulation
{
namespace
{

constexpr double kClaimSeenM = 90.0; ///< before a junction others know of it
constexpr double kToLineMps2 = 1.5, kGiveBackMps2 = 4.0;
constexpr double kDecidesM = 10.0; ///< from where it brakes gently for a line it asks
/// beside its own length, behind the place where its rear axle has left a junction
constexpr double kRoomBehindM = 1.2;
constexpr double kBeforeJunctionM = 1.0;
constexpr double kBeforeNarrowM = 0.5;
constexpr double kRoomBetweenM = 0.2; ///< two junctions, to stand there without being in the way
constexpr double kOfJunctionM = 3.0;  ///< behind where a junction begins, lines still count as before it
constexpr double kWayLookM = 100.0;   ///< at most; else to stop in, and more
constexpr double kWayLeastM = 20.0, kWayLookS = 2.0;

/// The room that it keeps before it, when it has to wait. Where others swing out before a junction, the lane
/// is narrow.
double roomBefore(const JunctionClaim& claim)
{
    return claim.isNarrow ? kBeforeNarrowM : kBeforeJunctionM;
}

/// The state of a traffic light; null: nobody has switched it.
const std::string* lightState(const ActionScene& scene, const DrivenWay::Line& line)
{
    const auto found = scene.signalStates().find(line.light);
    return line.light.empty() || found == scene.signalStates().end() ? nullptr : &found->second;
}

} // namespace

WayDriver::WayDriver(ActionScene& scene, std::shared_ptr<JunctionKeeper> keeper, int actor, bool givesWay)
    : _keeper(std::move(keeper)),
      _actor(actor),
      _givesWay(givesWay),
      _way(_keeper->table(), scene.motion(actor).turns())
{
    _keeper->of(actor) = {};
}

WayDriver::~WayDriver()
{
    _keeper->leave(_actor);
}

std::optional<WayAdvice> WayDriver::look(ActionScene& scene, double speedMps)
{
    _keeper->setTime(scene.timeS());
    _own = &_keeper->of(_actor);
    if (!_way.follow(scene.motion(_actor))) return std::nullopt;
    measure(scene, speedMps);
    WayAdvice advice;
    advice.allowedMps = _way.allowedMps();
    _ahead = leadsOnWay(scene, _actor, _way, *_keeper, lookM());
    if (!_ahead.empty()) advice.lead = _ahead.front();
    lookAtLines(scene, advice);
    JunctionApproach& own = *_own;
    constexpr double kBehindM = 5.0;
    const bool isBehind = advice.lead && advice.lead->gapM < kBehindM;
    _isInKnot = !isBehind && _keeper->isInKnot(_actor);
    own.waitsFor = -1;
    if (_givesWay)
    {
        giveBack();
        advice.lineM = ask(scene);
    }
    if (isBehind) own.waitsFor = advice.lead->entity;
    return advice;
}

/// How far it looks for others: to stop, and behind the junctions before it for room.
double WayDriver::lookM() const
{
    constexpr double kBehindJunctionM = 25.0;
    const JunctionApproach& own = *_own;
    const double stopsM = own.speedMps * own.speedMps / (2.0 * kToLineMps2);
    double aheadM = kWayLeastM + kWayLookS * own.speedMps + stopsM;
    const std::size_t first = firstNotHeld();
    if (first < own.claims.size() && -own.claims[first].frontM < stopsM + kDecidesM)
        aheadM = std::max(aheadM, endOf(chainFrom(first) - 1) + kBehindJunctionM - _frontM);
    return std::min(aheadM, kWayLookM);
}

std::size_t WayDriver::firstNotHeld() const
{
    const auto& claims = _own->claims;
    return static_cast<std::size_t>(
        std::find_if(claims.begin(), claims.end(), [](const JunctionClaim& claim) { return !claim.isHeld; }) -
        claims.begin());
}

/// Where the claims are now; new ones come within sight, old ones lie behind.
void WayDriver::measure(ActionScene& scene, double speedMps)
{
    constexpr double kStandsMps = 0.3;
    const BoundingBox& box = boxOf(scene, _actor);
    _frontM = _way.alongM() + box.centre.x + 0.5 * box.lengthM;
    JunctionApproach& own = *_own;
    own.seenS = scene.timeS();
    own.lengthM = box.lengthM;
    own.speedMps = speedMps;
    own.standsS = speedMps < kStandsMps ? own.standsS + scene.stepS() : 0.0;
    std::vector<JunctionClaim> claims;
    for (const DrivenWay::Crossing& crossing : _way.crossings())
    {
        const double rearM = _frontM - box.lengthM;
        if (crossing.toM < rearM || crossing.fromM > _frontM + kClaimSeenM) continue;
        JunctionClaim claim{crossing.lane, crossing.fromM, _frontM - crossing.fromM, rearM - crossing.fromM,
                            _frontM > crossing.fromM + 0.5};
        claim.toM = crossing.toM;
        claim.onLaneM = crossing.onLaneM;
        claim.isNarrow = crossing.isNarrow;
        claim.met = crossing.met;
        claim.junction = crossing.junction;
        for (const JunctionClaim& before : own.claims)
            if (before.isHeld && before.fromM == crossing.fromM && before.lane == crossing.lane)
                claim.isHeld = true;
        claims.push_back(claim);
    }
    own.claims = std::move(claims);
}

/// What stands before it: the next sign, and the first light at which it has to stop.
void WayDriver::lookAtLines(const ActionScene& scene, WayAdvice& advice)
{
    constexpr double kBeforeLineM = 1.0;
    constexpr double kAmberMps2 = 4.0, kRedMps2 = 8.0; ///< of one who stops at a light
    const double speedMps = _own->speedMps;
    std::optional<double> redAtM;
    for (const DrivenWay::Line& line : _way.lines())
    {
        const double gapM = line.alongM - _frontM;
        if (gapM < 0.0) continue;
        if (line.light.empty() && !advice.signM) advice.signM = gapM;
        const std::string* const state = lightState(scene, line);
        if (!state || letsPass(*state) || redAtM) continue;
        const double brakesMps2 = isAmber(*state) ? kAmberMps2 : kRedMps2;
        if (comesTooLate(gapM, speedMps, brakesMps2)) continue;
        if (goesOnAmber(scene, line, *state)) continue;
        redAtM = line.alongM;
        advice.lightM = gapM - kBeforeLineM;
    }
    markLights(scene, redAtM);
    for (const JunctionClaim& claim : _own->claims)
        if (claim.isBehindRed)
            advice.lightM = std::min(advice.lightM.value_or(1e300), -claim.frontM - roomBefore(claim));
}

/// Who has waited at the line on green, as those do who turn across the way of others, goes on amber, where
/// it is over the line before red.
bool WayDriver::goesOnAmber(const ActionScene& scene, const DrivenWay::Line& line, const std::string& state)
{
    constexpr double kAtLineM = 2.5, kWaitedS = 2.0, kBeginsS = 0.7, kGoesMps = 1.0;
    const JunctionApproach& own = *_own;
    if (line.alongM - _frontM > kAtLineM) return false;
    if (!isAmber(state))
    {
        _amber.reset();
        return false;
    }
    if (!_amber || _amber->lineM != line.alongM)
        _amber = Amber{line.alongM, scene.timeS(), own.standsS > kWaitedS};
    return _amber->hasWaited && (scene.timeS() - _amber->sinceS < kBeginsS || own.speedMps > kGoesMps);
}

/// Tells others at junctions what lights say of it. Who stands at a light waits for nobody.
void WayDriver::markLights(const ActionScene& scene, std::optional<double> redAtM)
{
    JunctionApproach& own = *_own;
    for (JunctionClaim& claim : own.claims)
    {
        claim.isBehindRed = claim.frontM < 0.5 && redAtM && *redAtM < claim.fromM + kOfJunctionM;
        if (claim.isBehindRed)
        {
            claim.isHeld = false;
            own.standsS = 0.0;
        }
        double fromM = -1e300; // where the junction before it ends
        for (const DrivenWay::Crossing& crossing : _way.crossings())
            if (crossing.fromM < claim.fromM && !crossing.isNarrow) fromM = crossing.toM - kOfJunctionM;
        for (const DrivenWay::Line& line : _way.lines())
        {
            if (line.alongM < fromM || line.alongM > claim.fromM + kOfJunctionM) continue;
            const std::string* const state = lightState(scene, line);
            claim.isAtLight = claim.isAtLight || (state && !isSwitchedOff(*state));
        }
    }
    // What has to be passed together with a junction waits for its light.
    for (std::size_t i = own.claims.size(); i-- > 1;)
        if (own.claims[i].isBehindRed && own.claims[i - 1].isNarrow && own.claims[i - 1].frontM < 0.5 &&
            isChained(i))
        {
            own.claims[i - 1].isBehindRed = true;
            own.claims[i - 1].isHeld = false;
        }
}

double WayDriver::endOf(std::size_t claim) const
{
    return std::min(_own->claims[claim].toM, _way.points().back().alongM);
}

/// Whether a junction has to be passed together with the one before it, because there is no room to stand
/// between them.
bool WayDriver::isChained(std::size_t claim) const
{
    const JunctionApproach& own = *_own;
    return claim > 0 && own.claims[claim].fromM - endOf(claim - 1) < own.lengthM + kRoomBetweenM;
}

/// The end of the junctions that have to be passed together.
std::size_t WayDriver::chainFrom(std::size_t first) const
{
    std::size_t end = first + 1;
    while (end < _own->claims.size() && isChained(end))
        ++end;
    return end;
}

/// Who was let in and cannot go gives back all that it has to pass together; what it has to pass together
/// with that in which it stands not before it has stood for long.
void WayDriver::giveBack()
{
    constexpr double kStandsS = 2.0, kInM = -0.5;
    JunctionApproach& own = *_own;
    for (std::size_t first = 0, end = 0; first < own.claims.size(); first = end)
    {
        end = chainFrom(first);
        const JunctionClaim& begin = own.claims[first];
        const bool isBegun = begin.frontM > kInM;
        const auto isLost = [&](const JunctionClaim& claim) { return !claim.isHeld; };
        bool isGiven = !isBegun && std::any_of(own.claims.begin() + static_cast<std::ptrdiff_t>(first),
                                               own.claims.begin() + static_cast<std::ptrdiff_t>(end), isLost);
        const bool isLeadBefore = !_ahead.empty() && _ahead.front().rearM < begin.fromM + 1.0;
        const bool canStop = own.speedMps * own.speedMps < -2.0 * kGiveBackMps2 * begin.frontM;
        if (isBegun)
            isGiven = own.standsS > JunctionKeeper::kPatienceS && !_ahead.empty() &&
                      !_keeper->isKept(_ahead.front().entity);
        else if ((isLeadBefore && own.standsS > kStandsS) ||
                 (canStop && begin.isHeld && whoTakesRoom(first, end)))
            isGiven = true;
        for (std::size_t i = first; isGiven && i < end; ++i)
            own.claims[i].isHeld = own.claims[i].frontM > kInM;
    }
}

/// Asks for the next junctions. Returns the way to the line before them; nothing: it may go on.
std::optional<double> WayDriver::ask(ActionScene& scene)
{
    JunctionApproach& own = *_own;
    const std::size_t first = firstNotHeld();
    if (first == own.claims.size() || own.claims[first].isBehindRed) return std::nullopt;
    const double lineM = -own.claims[first].frontM - roomBefore(own.claims[first]);
    if (lineM > own.speedMps * own.speedMps / (2.0 * kToLineMps2) + kDecidesM) return std::nullopt;
    const std::size_t end = chainFrom(first);
    for (std::size_t i = first; i < end; ++i)
        own.claims[i].isAsked = true;
    const auto standing = whoTakesRoom(first, end);
    own.hasRoomBehind = !standing;
    if (standing) own.waitsFor = *standing;
    // Of a ring of vehicles, each without room behind the next junction, one has to go on.
    if (standing && !_isInKnot) return lineM;
    if (isStrangerAhead(scene, first, end)) return lineM;
    for (std::size_t i = first; i < end; ++i)
    {
        own.waitsFor = _keeper->inTheWay(_actor, own.claims[i], _isInKnot);
        if (own.waitsFor >= 0) return lineM;
    }
    for (std::size_t i = first; i < end; ++i)
        own.claims[i].isHeld = true;
    return std::nullopt;
}

/// Who stands behind the junctions, or before them, so that the vehicle could not leave them again; nothing:
/// there is room for it and for all who go there before it.
std::optional<int> WayDriver::whoTakesRoom(std::size_t first, std::size_t end) const
{
    constexpr double kGoesMps = 2.5;
    const JunctionApproach& own = *_own;
    JunctionTable& table = _keeper->table();
    // A ring goes on when all in it go on; whoever comes into it needs the room.
    bool staysInRing = !own.claims[first].isNarrow;
    for (std::size_t i = first; i < end; ++i)
        staysInRing = staysInRing && (own.claims[i].isNarrow || table.staysInRing(own.claims[i].lane));
    double needsM = own.lengthM + kRoomBehindM;
    for (const LeadOnWay& other : _ahead)
    {
        if (!other.isAlong && _keeper->isKept(other.entity)) continue; // it goes another way, and is asked
        const bool isBefore = other.rearM < own.claims[first].fromM + 1.0;
        if (other.speedMps > kGoesMps || (staysInRing && !isBefore))
        {
            needsM += other.lengthM + kRoomBehindM;
            continue;
        }
        if (isBefore || other.rearM < endOf(end - 1) + needsM) return other.entity;
        return std::nullopt;
    }
    return std::nullopt;
}

/// Whether somebody who asks nobody, as a person does not, is there or will be while the vehicle passes.
bool WayDriver::isStrangerAhead(ActionScene& scene, std::size_t first, std::size_t end) const
{
    constexpr double kNearM = 80.0, kCrossingM = 3.0, kAbreastM = 2.0, kLookS = 0.5, kMostS = 6.0;
    const JunctionApproach& own = *_own;
    const double fromM = own.claims[first].fromM, toM = endOf(end - 1);
    const double passesS = std::min(kMostS, secondsFor(toM - _frontM + own.lengthM, own.speedMps) + 1.0);
    const EntityState& self = scene.motion(_actor).state();
    const glm::dvec2 ahead(self.bodyToLocal()[0]);
    for (int i = 0; i < static_cast<int>(scene.scenario().entities.size()); ++i)
    {
        if (i == _actor || !scene.isPresent(i) || _keeper->isKept(i)) continue;
        const EntityState& other = scene.motion(i).state();
        const glm::dvec2 apart(other.position - self.position), velocity(other.velocity);
        if (glm::length(apart) > kNearM || std::fabs(other.position.z - self.position.z) > kNearM) continue;
        const bool followsIt = glm::dot(apart, ahead) < 0.0 && glm::dot(velocity, ahead) >= 0.0;
        const bool leadsIt = !_ahead.empty() && _ahead.front().entity == i && _ahead.front().speedMps > 1.0;
        if (followsIt || leadsIt) continue;
        const BoundingBox& box = boxOf(scene, i);
        const glm::dvec2 middle = glm::dvec2(other.position + other.bodyToLocal() * box.centre);
        for (double laterS = 0.0; laterS <= passesS; laterS += kLookS)
            for (const DrivenWay::Point& point : _way.points())
            {
                if (point.alongM < fromM || point.alongM > toM) continue;
                if (std::fabs(point.place.z - other.position.z) > 3.5) continue;
                const double turn = std::sin(foundation::radiansOf(other.headingDeg) - point.headingRad);
                const double nearM = std::fabs(turn) < 0.35 ? kAbreastM : kCrossingM;
                const glm::dvec2 between = middle + laterS * velocity - glm::dvec2(point.place);
                if (glm::dot(between, between) < nearM * nearM) return true;
            }
    }
    return false;
}

} // namespace simulation
