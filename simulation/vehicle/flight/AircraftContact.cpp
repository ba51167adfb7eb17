// SPDX-License-Identifier: Apache-2.0
// How an aircraft meets the ground, water and what stands, what breaks of it, and how its wreck comes to
// rest.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "simulation/vehicle/BedGround.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/road/ObstacleMeeting.h"

namespace simulation
{

namespace
{

constexpr double kDeepestM = 0.3;     ///< below the ground; deeper points are lifted out
constexpr double kDeepestHullM = 0.5; ///< the same of a wreck's corners, at once
constexpr double kLeftM = 0.03;       ///< depth of a wreck's corners that is left
constexpr double kLiftMps = 1.0;      ///< how fast those that lie deeper are lifted
constexpr double kTurnsRadps = 5.0;   ///< a propeller that turns faster breaks where it strikes
constexpr double kBentShare = 0.3;    ///< of a wing's lift that a bend takes
constexpr double kBendsShare = 0.07;  ///< of the closing speed that crashes it, from where on a wing bends
/// of the speed that bends a wing tip or a propeller, where all is over
constexpr double kHardFactor = 2.5;
constexpr double kDrownsM = 0.3; ///< depth of a part under water at which it has come down there
constexpr double kToldMps = 1.0; ///< of a wreck's blows against the ground
constexpr double kCreepMps = 0.5, kCreepRadps = 0.3; ///< of a wreck that creeps to rest
constexpr double kCreepS = 0.3;                      ///< in which what is bent takes a third of that: chosen
constexpr double kLiesMps = 0.05, kLiesRadps = 0.05, kLiesS = 1.0; ///< then a wreck has come to rest
constexpr double kOffS = 0.25; ///< for which a wreck that lies may touch nothing

bool isWingTip(const ContactData& part, double spanM)
{
    return !part.isWheel && std::abs(part.place.y) > 0.3 * spanM;
}

/// A skid that stands for the propeller's lowest reach.
bool isPropellerTip(const ContactData& part, const PropellerData& propeller)
{
    const glm::dvec3 apart = part.place - propeller.place;
    const double nearM = 0.2 * propeller.diameterM;
    return !part.isWheel && std::abs(apart.x) < nearM && std::abs(apart.y) < nearM && apart.z < -nearM;
}

std::string joined(const std::string& one, const std::string& other)
{
    return one + (one.empty() || other.empty() ? "" : ", ") + other;
}

} // namespace

/// The first reason stays. The hull stands for the skids from now on.
void Aircraft::crash(std::string_view reason)
{
    if (_status.condition != VehicleCondition::sound) return;
    _status = {VehicleCondition::crashed, reason};
    _state.engineRadps = 0.0;
    for (std::size_t i = 0; i < _data->contacts.size(); ++i)
        if (!_data->contacts[i].isWheel) _contacts.drop(i);
}

void Aircraft::noteImpact(std::uint32_t thing, double closingMps, const glm::dvec3& place, std::string damage)
{
    _hull.note({_timeS + kStepS, thing, closingMps, place, _velocityBefore, false, std::move(damage)});
}

/// Returns what to tell; empty: it was broken before.
std::string Aircraft::breakPropeller()
{
    if (std::exchange(_damage.isPropellerBroken, true)) return {};
    _state.engineRadps = 0.0;
    return "propeller broken, engine stopped";
}

/// Returns what to tell; empty: it was bent before.
std::string Aircraft::bendWing(bool isRight)
{
    double& lost = _damage.wingLost[isRight ? 1 : 0];
    if (lost > 0.0) return {};
    lost = kBentShare;
    return isRight ? "right wing bent" : "left wing bent";
}

/// A bent wing carries less, and the other one rolls it.
void Aircraft::bearDamage(ForceMoment& load) const
{
    const double normal = load.force.z;
    for (const bool isRight : {false, true})
    {
        const double lost = -0.5 * _damage.wingLost[isRight ? 1 : 0] * normal;
        load.force.z += lost;
        load.moment.x += (isRight ? 0.25 : -0.25) * _data->wingSpanM * lost;
    }
}

/// Before the short steps: finds what is near and lays the ground below a wreck.
void Aircraft::lookAround(const MassProperties& mass, const Ground& ground)
{
    BodyMotion& motion = _state.motion;
    _hull.look(motion, mass, _surroundings.earthRate, _timeS + kStepS, kStepS);
    if (std::abs(_state.engineRadps) > kTurnsRadps)
        if (const auto struck = _hull.inPropeller(motion, mass))
            noteImpact(*struck, glm::length(motion.velocity), motion.position, breakPropeller());
    const bool isInWater = _below.isKnown && _below.kind == GroundKind::water;
    _waterM = isInWater ? std::optional(_below.heightM) : std::nullopt;
    _isFilling = false;
    if (_waterM)
    {
        const double airBefore = _hull.airShare();
        _hull.fill(motion, mass, *_waterM, kStepS);
        _isFilling = _hull.airShare() < airBefore;
    }
    _isOnHull = false;
    if (_status.condition != VehicleCondition::crashed || _heightAboveGroundM > kLowM) return;
    const BedGround bed(ground);
    const double deepest = _hull.deepestM(motion, mass, bed);
    if (deepest > kDeepestHullM) motion.velocity.z = std::max(0.0, motion.velocity.z);
    if (deepest > kLeftM)
        motion.position.z +=
            deepest > kDeepestHullM ? deepest : std::min(deepest - kLeftM, kLiftMps * kStepS);
    lieOnHull(mass, ground);
}

void Aircraft::lieOnHull(const MassProperties& mass, const Ground& ground)
{
    _isOnHull = true;
    _hull.layGround(_state.motion, mass, BedGround(ground));
}

/// Breaks what is pressed too fast, and notices whether a wheel stands on the ground, or any part of a wreck.
void Aircraft::judgeContacts()
{
    const std::span<const Contact> contacts = _contacts.contacts();
    for (std::size_t i = 0; i < contacts.size(); ++i)
    {
        const glm::dvec3 place = _state.motion.position + _state.motion.attitude * contacts[i].arm;
        if (contacts[i].waterM && place.z < *contacts[i].waterM - kDrownsM &&
            _status.condition == VehicleCondition::sound)
        {
            noteImpact(ObstacleMeeting::kWater, glm::length(_velocityBefore), place, breakPropeller());
            crash("it came down on water");
        }
        if (contacts[i].depthM <= 0.0 || contacts[i].isGone) continue;
        const ContactData& data = _data->contacts[i];
        _isOnGround = _isOnGround || data.isWheel || _status.condition == VehicleCondition::crashed;
        judgePart(i, place);
    }
}

/// What a part that touches the ground bears.
void Aircraft::judgePart(std::size_t index, const glm::dvec3& place)
{
    const ContactData& data = _data->contacts[index];
    const double closingMps = _contacts.contacts()[index].closingMps;
    const bool isTooFast = closingMps > data.strongestMps;
    std::string damage;
    if (isPropellerTip(data, _data->propeller) && std::abs(_state.engineRadps) > kTurnsRadps)
        damage = breakPropeller();
    if (isTooFast && data.isWheel) damage = joined(damage, data.name + " gear broken");
    if (isTooFast && isWingTip(data, _data->wingSpanM)) damage = joined(damage, bendWing(data.place.y > 0.0));
    if (!isTooFast && damage.empty()) return;
    noteImpact(ObstacleMeeting::kGround, std::max(closingMps, ObstacleMeeting::kLeastToldMps), place, damage);
    if (isTooFast && data.isWheel)
    {
        _contacts.drop(index);
        return crash("its gear broke at touchdown");
    }
    const bool bearsMore = isWingTip(data, _data->wingSpanM) || isPropellerTip(data, _data->propeller);
    if (closingMps > (bearsMore ? kHardFactor : 1.0) * data.strongestMps) crash("it hit the ground");
}

/// A point far below the ground (a cliff, a start inside a hill) is lifted, without speed of its own: a
/// spring so far pressed would throw the aircraft.
void Aircraft::liftOutOfGround()
{
    glm::dvec3 normal(0.0, 0.0, 1.0);
    const double deepest = _contacts.deepestM(_state.motion, normal);
    if (deepest <= kDeepestM) return;
    if (_status.condition == VehicleCondition::sound)
        noteImpact(ObstacleMeeting::kGround, glm::length(_state.motion.velocity), _state.motion.position, {});
    crash("it hit the ground");
    _state.motion.position.z += deepest - kDeepestM;
    const double inward = glm::dot(_state.motion.velocity, normal);
    if (inward < 0.0) _state.motion.velocity -= inward * normal;
}

/// What stands and moves, and the ground below a wreck, in a short step that has led here from `before`.
void Aircraft::meetHull(const BodyMotion& before, const MassProperties& mass, double stepS)
{
    const HullContact contact =
        _hull.resolve(before, _state.motion, mass, _surroundings.earthRate, _timeS + kStepS, stepS);
    if (!contact.touches && contact.closingMps <= 0.0) return;
    if (_status.condition == VehicleCondition::crashed)
    {
        _isOnGround = _isOnGround || contact.touches;
        if (contact.groundMps > kToldMps)
            noteImpact(ObstacleMeeting::kGround, contact.groundMps, contact.place, {});
        return;
    }
    const double crashesAtMps = _data->hull.crashesAtMps;
    if (contact.closingMps > crashesAtMps) return crash(contact.reason);
    constexpr double kBodyShare = 0.12; // of the span on each side, within which it is no wing
    const glm::dvec3 arm = glm::conjugate(_state.motion.attitude) * (contact.place - _state.motion.position);
    if (contact.closingMps < kBendsShare * crashesAtMps || std::abs(arm.y) < kBodyShare * _data->wingSpanM)
        return;
    if (std::string damage = bendWing(arm.y > 0.0); !damage.empty())
        noteImpact(contact.thing, contact.closingMps, contact.place, std::move(damage));
}

/// A wreck that creeps comes to rest, and stays as it lies.
void Aircraft::judgeRest()
{
    BodyMotion& motion = _state.motion;
    const glm::dvec3 rates = motion.rates - glm::conjugate(motion.attitude) * _surroundings.earthRate;
    const double speed = glm::length(motion.velocity), turning = glm::length(rates);
    _offS = _isOnGround ? 0.0 : _offS + kStepS;
    const bool lies = _status.condition == VehicleCondition::crashed && _offS < kOffS && !_isFilling &&
                      !_hull.hasMovers() && speed < kCreepMps && turning < kCreepRadps;
    if (lies)
    {
        motion.velocity *= 1.0 - kStepS / kCreepS;
        motion.rates -= kStepS / kCreepS * rates;
    }
    _stillS = lies && speed < kLiesMps && turning < kLiesRadps ? _stillS + kStepS : 0.0;
    if (_stillS < kLiesS) return;
    _isAtRest = true;
    motion.velocity = glm::dvec3(0.0);
    motion.rates = glm::conjugate(motion.attitude) * _surroundings.earthRate;
}

} // namespace simulation
