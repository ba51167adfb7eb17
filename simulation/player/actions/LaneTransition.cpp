// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/actions/LaneTransition.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulation/player/TransitionShape.h"

namespace simulation
{
namespace
{

constexpr double kSameTime = 1e-9;
constexpr double kSlowestSidewaysMps = 1e-3;

} // namespace

LaneTransition::LaneTransition(const Course& course, const EntityMotion& actor, const RoadScene& roads)
    : _course(course)
{
    const RoadPlace& place = *actor.state().place;
    RoadPlace middle = place;
    _fromOffsetM = roads.putOnLane(middle, course.lane, 0.0) ? place.t - middle.t : place.laneOffsetM;
}

bool LaneTransition::step(ActionScene& scene, EntityMotion& actor)
{
    const double speed = actor.state().speedMps;
    const double before = _course.duration > 0.0 ? _done / _course.duration : 1.0;
    if (_course.isAhead || std::exchange(_hasBegun, true))
        _done += _course.isByDistance ? std::fabs(speed) * scene.stepS() : scene.stepS();
    const double now = _course.duration > 0.0 ? (_done + kSameTime) / _course.duration : 1.0;
    const double change = _course.toOffsetM - _fromOffsetM;
    if (now >= 1.0)
    {
        actor.setLane(_course.lane, _course.toOffsetM, 0.0, 1.0);
        return !_course.isEndless;
    }
    const double perUnit =
        shapeSlope(_course.shape, _course.isAhead ? before : now) * change / _course.duration;
    const double sine =
        _course.isByDistance ? perUnit : perUnit / std::max(std::fabs(speed), kSlowestSidewaysMps);
    const bool stands = std::fabs(speed) < kSlowestSidewaysMps;
    const double turn = stands            ? 0.0
                        : _course.isAhead ? std::asin(std::clamp(sine, -1.0, 1.0))
                                          : std::atan(sine);
    actor.setLane(_course.lane, _fromOffsetM + change * shapeValue(_course.shape, now), turn,
                  _course.isAhead ? std::cos(turn) : 1.0);
    return false;
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
