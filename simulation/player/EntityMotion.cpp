// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/EntityMotion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <foundation/Angle.h>
#include <foundation/Earth.h>

namespace simulation
{
namespace
{

constexpr double kGreatestBankDeg = 60.0;
constexpr double kSmallestPlanSpeed = 1e-6;
constexpr double kBesideRoadM = 10.0; ///< so far from its lanes a road tells the height

double wrappedDeg(double angleDeg)
{
    return foundation::wrappedDeg(angleDeg);
}

} // namespace

EntityMotion::EntityMotion(const ScenarioObject& object, const SceneFrame& frame, const RoadScene* roads)
    : _frame(&frame),
      _roads(object.isAirborne() ? nullptr : roads),
      _contact(GroundContact::of(object)),
      _isAirborne(object.isAirborne())
{
    _state.name = object.name;
    if (const auto* vehicle = std::get_if<Vehicle>(&object.object))
    {
        _mostAccelerationMps2 = vehicle->performance.maxAccelerationMps2;
        _mostDecelerationMps2 = vehicle->performance.maxDecelerationMps2;
        _mostSpeedMps = vehicle->performance.maxSpeedMps;
        _wheelRadiusM = 0.5 * vehicle->rearAxle.wheelDiameterM;
        if (vehicle->frontAxle) _wheelbaseM = vehicle->frontAxle->positionXM - vehicle->rearAxle.positionXM;
    }
    settle(0.0);
}

void EntityMotion::teleport(const Placement& placement, double timeS)
{
    if (_run) cancel(_runTicket, timeS);
    _state.position = placement.position;
    _state.headingDeg = wrappedDeg(glm::degrees(placement.headingRad));
    _givenPitchDeg = wrappedDeg(glm::degrees(placement.pitchRad));
    _givenRollDeg = wrappedDeg(glm::degrees(placement.rollRad));
    _state.pitchDeg = _givenPitchDeg;
    _state.rollDeg = _givenRollDeg;
    _state.place = _roads ? placement.place : std::nullopt;
    _state.isAtEndOfRoad = false;
    settle(timeS);
}

void EntityMotion::setSpeed(double speedMps, double timeS)
{
    _speed = SpeedProfile::constant(speedMps);
    _speedStartS = timeS;
    _speedTicket = ++_lastTicket;
}

void EntityMotion::towTo(const glm::dvec3& position, double headingRad, double speedMps)
{
    _state.odometerM += glm::length(position - _state.position);
    _state.position = position;
    _state.headingDeg = wrappedDeg(glm::degrees(headingRad));
    if (_roads) findPlace();
    _state.speedMps = speedMps;
    _state.velocity = _state.bodyToLocal()[0] * speedMps;
}

void EntityMotion::takeState(const EntityState& state, double timeS)
{
    EntityState taken = state;
    taken.name = std::move(_state.name);
    taken.place = _state.place;
    taken.animations = std::move(_state.animations);
    _state = std::move(taken);
    _timeS = timeS;
    if (!_roads) return;
    // What moves it knows how it stands.
    std::optional<RoadPlace> place = _roads->nearest(_state.position, glm::radians(_state.headingDeg));
    if (!place) return;
    place->heightM = _state.place ? _state.place->heightM : 0.0;
    _state.place = place;
}

void EntityMotion::goOn(double askedMps, double timeS)
{
    constexpr double kGentleMps2 = 2.0;
    _state.readings.reset();
    _state.aircraft.reset();
    _state.wheelTurnDeg.reset();
    _state.lamps.clear();
    _state.steeringDeg = 0.0;
    _state.isAtEndOfRoad = false;
    _givenPitchDeg = _givenRollDeg = 0.0;
    _timeS = timeS;
    setSpeed(_state.speedMps, timeS);
    if (_run)
        _run->rejoin(_state.position, timeS);
    else if (_state.place)
    {
        _state.place->heightM = 0.0;
        (void)_roads->takeLaneAhead(*_state.place);
    }
    else
        _state.pitchDeg = _state.rollDeg = 0.0;
    if (_run) takePoint(_run->point(), _run->isTimed() ? _run->timedSpeedMps() : _state.speedMps);
    SpeedAction asked;
    asked.dynamics = {DynamicsShape::linear, DynamicsDimension::rate, kGentleMps2};
    asked.target = AbsoluteTargetSpeed{askedMps};
    startSpeed(asked, timeS);
}

void EntityMotion::setLane(int lane, double offsetM, double turnRad)
{
    if (!_state.place || !_roads->putOnLane(*_state.place, lane, offsetM)) return;
    const bool isForward = std::cos(_state.place->relativeHeadingRad) >= 0.0;
    // A turn to the left of the reference line turns the nose to the right of one that drives against it.
    _state.place->relativeHeadingRad = isForward ? turnRad : std::numbers::pi - turnRad;
}

std::int64_t EntityMotion::startSpeed(const SpeedAction& action, double timeS)
{
    const auto* target = std::get_if<AbsoluteTargetSpeed>(&action.target);
    double to = target ? target->speedMps : _state.speedMps;
    if (_roads && _mostSpeedMps > 0.0) to = std::clamp(to, -_mostSpeedMps, _mostSpeedMps);
    TransitionDynamics dynamics = action.dynamics;
    const double most = to > _state.speedMps ? _mostAccelerationMps2 : _mostDecelerationMps2;
    if (_roads && most > 0.0) dynamics = SpeedProfile::within(most, _state.speedMps, to, dynamics);
    _speed = SpeedProfile(_state.speedMps, to, dynamics);
    _speedStartS = timeS;
    _speedTicket = ++_lastTicket;
    settle(timeS);
    return _speedTicket;
}

std::int64_t EntityMotion::startTrajectory(const FollowTrajectoryAction& action, double timeS)
{
    _run.emplace(action, *_frame, timeS, _roads != nullptr);
    _runTicket = ++_lastTicket;
    takePoint(_run->point(), _run->isTimed() ? _run->timedSpeedMps() : _speed.speedAt(timeS - _speedStartS));
    settle(timeS);
    return _runTicket;
}

bool EntityMotion::isDone(std::int64_t ticket, double timeS) const
{
    if (ticket == _runTicket) return !_run;
    return ticket != _speedTicket || timeS - _speedStartS >= _speed.durationS();
}

void EntityMotion::cancel(std::int64_t ticket, double timeS)
{
    if (ticket == _runTicket) _run.reset();
    if (ticket != _speedTicket && ticket != _runTicket) return;
    _speed = SpeedProfile::constant(_state.speedMps);
    _speedStartS = timeS;
}

void EntityMotion::advanceTo(double timeS, double stepS)
{
    const double distance =
        _roads ? roadStepM(timeS, stepS)
               : _speed.distanceAt(timeS - _speedStartS) - _speed.distanceAt(_timeS - _speedStartS);
    const glm::dvec3 before = _state.position;
    if (std::exchange(_standsForAStep, false))
        ;
    else if (_run)
        followTrajectory(timeS, distance);
    else if (_state.place)
        goAlongLane(distance, timeS);
    else
        goStraight(distance);
    if (!_state.place) _state.odometerM += glm::length(_state.position - before);
    settle(timeS);
    if (_state.place) _state.odometerM += glm::length(_state.position - before);
    _timeS = timeS;
}

/// By the speed at the end of the step, or that at its beginning where a lane change moves the entity before
/// its speed changes.
double EntityMotion::roadStepM(double timeS, double stepS) const
{
    const bool isBefore = _along && _along->order < _speedTicket;
    return _speed.speedAt((isBefore ? _timeS : timeS) - _speedStartS) * stepS;
}

void EntityMotion::followTrajectory(double timeS, double distanceM)
{
    const bool isTimed = _run->isTimed();
    const std::optional<double> left = isTimed ? _run->advanceTo(timeS) : _run->advanceBy(distanceM);
    takePoint(_run->point(), isTimed ? _run->timedSpeedMps() : _speed.speedAt(timeS - _speedStartS));
    if (!left) return;
    _run.reset();
    if (_roads) findPlace();
    if (isTimed)
    {
        _speed = SpeedProfile::constant(_state.speedMps);
        _speedStartS = timeS;
    }
    const double rest = isTimed ? *left * _state.speedMps : *left;
    if (_state.place)
        goAlongLane(rest, timeS);
    else
        goStraight(rest);
}

void EntityMotion::goAlongLane(double distanceM, double timeS)
{
    _state.steeringDeg = 0.0;
    const double share = std::exchange(_along, std::nullopt).value_or(AlongLane{}).share;
    if (distanceM == 0.0) return;
    if (!walk(*_roads, *_state.place, distanceM * share, _way, _turns ? &*_turns : nullptr))
    {
        _state.isAtEndOfRoad = true;
        setSpeed(0.0, timeS);
    }
}

WayAhead EntityMotion::wayAhead(double lengthM) const
{
    if (_run) return {_run->pointsAhead(lengthM), {}};
    return _state.place ? wayAlongLane(*_roads, *_state.place, _way, _turns, lengthM) : WayAhead{};
}

std::optional<double> EntityMotion::wayOnTrajectory(const glm::dvec3& place) const
{
    return _run ? _run->wayTo(place) : std::nullopt;
}

void EntityMotion::setPlace(const RoadPlace& place)
{
    _state.place = place;
    standOnRoad();
}

/// Takes position and angles from the place on the road.
void EntityMotion::standOnRoad()
{
    const RoadPose pose = _roads->poseAt(*_state.place);
    _state.position = pose.position;
    _state.headingDeg = wrappedDeg(glm::degrees(pose.headingRad));
    _state.pitchDeg = wrappedDeg(glm::degrees(pose.pitchRad) + _givenPitchDeg);
    _state.rollDeg = wrappedDeg(glm::degrees(pose.rollRad) + _givenRollDeg);
    if (std::fabs(_state.place->t) > kBesideRoadM) standOnGroundFarFromRoads();
}

/// The surface of a road says nothing about the height of places far beside it.
void EntityMotion::standOnGroundFarFromRoads()
{
    if (!_roads->hasRoadWithin(kBesideRoadM, _state.position)) standOnGround(_contact, *_frame, _state);
}

/// Finds the place on the road of an entity that has moved without it; it then stands on the road.
void EntityMotion::findPlace()
{
    std::optional<RoadPlace> place = _roads->nearest(_state.position, glm::radians(_state.headingDeg));
    if (!place) return;
    place->heightM = _state.place ? _state.place->heightM : 0.0;
    _state.place = place;
    _state.position.z = _roads->poseAt(*place).position.z;
    standOnGroundFarFromRoads();
}

/// Along the heading; an airborne entity climbs or sinks with its pitch.
void EntityMotion::goStraight(double distanceM)
{
    const double climb = _isAirborne ? -glm::radians(_state.pitchDeg) : 0.0;
    const double heading = glm::radians(_state.headingDeg);
    const glm::dvec3 ahead(std::cos(heading) * std::cos(climb), std::sin(heading) * std::cos(climb),
                           std::sin(climb));
    _state.position += ahead * distanceM;
    _state.steeringDeg = 0.0;
}

void EntityMotion::takePoint(const PathPoint& point, double speedMps)
{
    _state.position = point.position;
    if (point.headingRad) _state.headingDeg = wrappedDeg(glm::degrees(*point.headingRad));
    const double plan = std::hypot(point.tangent.x, point.tangent.y);
    const double climbRad = std::atan2(point.tangent.z, plan);
    if (plan > kSmallestPlanSpeed) _state.pitchDeg = -glm::degrees(climbRad);
    if (point.pitchRad) _state.pitchDeg = wrappedDeg(glm::degrees(*point.pitchRad));
    const double planSpeed = speedMps * std::cos(climbRad);
    const double curvature = point.planCurvature();
    const double bank =
        glm::degrees(std::atan(planSpeed * planSpeed * curvature / foundation::kStandardGravityMps2));
    _state.rollDeg = _isAirborne ? -std::clamp(bank, -kGreatestBankDeg, kGreatestBankDeg) : 0.0;
    if (point.rollRad) _state.rollDeg = wrappedDeg(glm::degrees(*point.rollRad));
    _state.steeringDeg = glm::degrees(std::atan(_wheelbaseM * curvature));
    _state.speedMps = speedMps;
    const double length = glm::length(point.tangent);
    _state.velocity = length > 0.0 ? point.tangent * (speedMps / length) : glm::dvec3(0.0);
}

/// What follows from place and speed.
void EntityMotion::settle(double timeS)
{
    if (!_run || !_run->isTimed()) _state.speedMps = _speed.speedAt(timeS - _speedStartS);
    _state.isOnGround = false;
    _state.wheelTravelM = {};
    if (_roads && _run)
        findPlace();
    else if (_state.place)
        standOnRoad();
    else if (!_isAirborne)
        standOnGround(_contact, *_frame, _state);
    if (!_run || _state.isOnGround) _state.velocity = _state.bodyToLocal()[0] * _state.speedMps;
    if (_wheelRadiusM > 0.0)
        _state.wheelRotationDeg = std::fmod(glm::degrees(_state.odometerM / _wheelRadiusM), 360.0);
}

} // namespace simulation
