// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/actions/LaneTransition.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <osgRoads/core/query/LaneSpan.h>

#include "simulation/player/TransitionShape.h"
#include "simulation/road/RoadScene.h"

namespace simulation
{
namespace
{

constexpr double kSameTime = 1e-9;
constexpr double kSlowestSidewaysMps = 1e-3;
constexpr double kGreatestTurnRad = 1.57; ///< less than a right angle: it looks along its way

} // namespace

LaneTransition::LaneTransition(const Course& course, const EntityMotion& actor, const RoadScene& roads)
    : _course(course)
{
    const RoadPlace& place = *actor.state().place;
    RoadPlace middle = place;
    _fromOffsetM = roads.putOnLane(middle, course.lane, 0.0) ? place.t - middle.t : place.laneOffsetM;
}

/// Where the entity comes to another lane section, the walk along the road has changed its lane by the links.
/// Within a section the lane stays that of the course: a vehicle with physics is still beside it.
void LaneTransition::followLinks(const RoadPlace& place, const osgRoads::core::LaneSection* section)
{
    const bool isForward = looksForward(place);
    if (_isOnLane && section != _section)
    {
        _course.lane = place.lane;
        if (isForward != _isForward)
        {
            _fromOffsetM = -_fromOffsetM;
            _course.toOffsetM = -_course.toOffsetM;
        }
    }
    _isForward = isForward;
    _section = section;
}

void LaneTransition::turnTo(EntityMotion& actor, double offsetM, double turnRad)
{
    actor.setLane(_course.lane, offsetM, std::clamp(turnRad, -kGreatestTurnRad, kGreatestTurnRad));
    _isOnLane = true;
}

double LaneTransition::now() const
{
    return _course.duration > 0.0 ? (_done + kSameTime) / _course.duration : 1.0;
}

double LaneTransition::offsetNow() const
{
    return _fromOffsetM + (_course.toOffsetM - _fromOffsetM) * shapeValue(_course.shape, now());
}

bool LaneTransition::arrive(EntityMotion& actor)
{
    turnTo(actor, _course.toOffsetM, 0.0);
    return !_course.isEndless;
}

bool LaneTransition::stepAhead(EntityMotion& actor, double stepS)
{
    if (_course.duration <= 0.0) return arrive(actor);
    const double speed = actor.state().speedMps;
    const double way = std::fabs(speed) * stepS;
    if (std::fabs(speed) < kSlowestSidewaysMps) return false;
    const double change = _course.toOffsetM - _fromOffsetM;
    const double perUnit = shapeSlope(_course.shape, _done / _course.duration) * change / _course.duration;
    double turn = std::atan(perUnit); // of metres by metres
    if (_course.isByDistance)
        _done += way * std::cos(turn);
    else
    {
        const double share = std::clamp(perUnit * stepS / way, -1.0, 1.0);
        turn = std::asin(share);
        _done += std::fabs(perUnit) * stepS > way ? way / std::fabs(perUnit) : stepS;
    }
    actor.goAlong({std::cos(turn), _course.order});
    if (now() >= 1.0) return arrive(actor);
    turnTo(actor, offsetNow(), speed < 0.0 ? -turn : turn);
    return false;
}

bool LaneTransition::stepOffset(EntityMotion& actor, double stepS)
{
    if (std::exchange(_hasBegun, true)) _done += stepS;
    if (now() >= 1.0) return arrive(actor);
    const double change = _course.toOffsetM - _fromOffsetM;
    const double rate = shapeSlope(_course.shape, now()) * change / _course.duration;
    const double speed = actor.state().speedMps;
    turnTo(actor, offsetNow(), std::fabs(speed) < kSlowestSidewaysMps ? 0.0 : std::atan(rate / speed));
    return false;
}

bool LaneTransition::step(ActionScene& scene, EntityMotion& actor)
{
    if (!actor.state().place || !scene.roads()) return true;
    const RoadPlace& place = *actor.state().place;
    followLinks(place, osgRoads::core::sectionAt(scene.roads()->roadAt(place), place.s));
    return _course.isAhead ? stepAhead(actor, scene.stepS()) : stepOffset(actor, scene.stepS());
}

double durationOf(const TransitionDynamics& dynamics, double amount)
{
    if (dynamics.shape == DynamicsShape::step) return 0.0;
    if (dynamics.dimension != DynamicsDimension::rate) return std::fabs(dynamics.value);
    return dynamics.value != 0.0
               ? steepestSlope(dynamics.shape) * std::fabs(amount) / std::fabs(dynamics.value)
               : 0.0;
}

} // namespace simulation
