// SPDX-License-Identifier: Apache-2.0
// How a road vehicle meets what stands beside and on its way.
#include <algorithm>
#include <cmath>

#include "simulation/vehicle/road/RoadVehicle.h"

namespace simulation
{

namespace
{

constexpr double kLookFurtherM = 0.5; ///< than a step takes it

} // namespace

/// The upright box around a box of the hull, turned with the vehicle.
HullPlan RoadVehicle::planOf(const HullBox& box) const
{
    const Axes body = axes();
    const glm::dvec3 middle = _motion.position + _motion.bodyToScene * (box.place - _mass.centre);
    const glm::dvec3 half = 0.5 * box.sizeM;
    HullPlan plan;
    plan.middle = glm::dvec2(middle);
    const double level = glm::length(glm::dvec2(body.forward));
    if (level > 1e-6) plan.along = glm::dvec2(body.forward) / level;
    const glm::dvec2 left(-plan.along.y, plan.along.x);
    const auto reach = [&](const glm::dvec2& axis)
    {
        return half.x * std::abs(glm::dot(glm::dvec2(body.forward), axis)) +
               half.y * std::abs(glm::dot(glm::dvec2(body.left), axis)) +
               half.z * std::abs(glm::dot(glm::dvec2(body.up), axis));
    };
    plan.halfM = {reach(plan.along), reach(left)};
    const double high =
        half.x * std::abs(body.forward.z) + half.y * std::abs(body.left.z) + half.z * std::abs(body.up.z);
    plan.lowM = middle.z - high;
    plan.highM = middle.z + high;
    return plan;
}

/// What stands fast goes into the world of bodies, where a step may take the vehicle to it; what gives acts
/// at once.
void RoadVehicle::lookAtObstacles()
{
    _touchedMovers.clear();
    if (!_obstacles.hasMap() && _obstacles.movers().empty() && !_hasMovers) return;
    double reachM = kLookFurtherM + glm::length(_motion.velocity) * kStepS;
    double hullM = 0.0;
    for (const HullBox& box : _data->hull.boxes)
        hullM = std::max(hullM, glm::length(box.place - _mass.centre) + 0.5 * glm::length(box.sizeM));
    reachM += hullM;
    const glm::dvec2 middle(_motion.position);
    bool isStruck = lookAtMovers(middle, reachM);
    if (_obstacles.hasMap())
    {
        _obstacles.look(middle - reachM, middle + reachM);
        _world->stand(_body, _obstacles.map(), _obstacles.fast());
        for (const std::uint32_t number : _obstacles.giving())
            meetGiving(_obstacles.map().at(number), number);
        isStruck = isStruck || !_obstacles.giving().empty();
    }
    if (isStruck) _motion = _world->motion(_body);
}

/// Vehicles become bodies that go on as they do; persons give way. Returns whether some of those are near.
bool RoadVehicle::lookAtMovers(const glm::dvec2& middle, double reachM)
{
    bool isStruck = false;
    std::vector<MovingObstacle> fast;
    for (const MovingObstacle& mover : _obstacles.movers())
    {
        const double farthestM = reachM + glm::length(mover.box.halfM) + glm::length(mover.velocity) * kStepS;
        if (glm::distance(mover.box.middle, middle) > farthestM) continue;
        if (standsFast(mover.box.kind))
            fast.push_back(mover);
        else if (!_obstacles.isBroken(mover))
        {
            meetGiving(mover.box, ObstacleMeeting::numberOf(mover.number));
            isStruck = true;
        }
    }
    if (!fast.empty() || _hasMovers) _world->accompany(fast);
    _hasMovers = !fast.empty();
    return isStruck;
}

/// Keeps what was touched, and how hard.
void RoadVehicle::noteHits(const SolidHit& hit)
{
    if (hit.obstacle)
        _obstacles.note(
            {_timeS + kStepS, *hit.obstacle, hit.obstacleMps, hit.place, _before.velocity, false});
    if (hit.mover)
        _obstacles.note({_timeS + kStepS, ObstacleMeeting::numberOf(*hit.mover), hit.moverMps, hit.moverPlace,
                         _before.velocity, false});
    for (const int mover : hit.movers)
    {
        const auto at = std::lower_bound(_touchedMovers.begin(), _touchedMovers.end(), mover);
        if (at == _touchedMovers.end() || *at != mover) _touchedMovers.insert(at, mover);
    }
}

void RoadVehicle::meetGiving(const Obstacle& obstacle, std::uint32_t number)
{
    const auto touching = std::find_if(_data->hull.boxes.begin(), _data->hull.boxes.end(),
                                       [&](const HullBox& box) { return overlaps(planOf(box), obstacle); });
    if (touching == _data->hull.boxes.end()) return;
    if (number >= ObstacleMeeting::kMovers)
        _touchedMovers.push_back(static_cast<int>(number - ObstacleMeeting::kMovers));
    const HullPlan plan = planOf(*touching);
    const SolidMotion motion = _world->motion(_body);
    const glm::dvec3 place(
        glm::clamp(obstacle.middle, plan.middle - plan.halfM.x, plan.middle + plan.halfM.x),
        std::clamp(motion.position.z, obstacle.lowM, obstacle.highM));
    const glm::dvec3 arm = place - motion.position;
    glm::dvec3 velocity = motion.velocity + glm::cross(motion.rates, arm);
    velocity.z = 0.0;
    const double speedMps = glm::length(velocity);
    if (speedMps < 1e-3 || glm::dot(glm::dvec2(velocity), obstacle.middle - plan.middle) <= 0.0) return;
    const glm::dvec3 ahead = velocity / speedMps;
    const GivingBlow blow =
        blowOf(obstacle.kind, speedMps, _mass.massKg, _world->inverseMassAt(_body, arm, ahead), kStepS);
    _world->strike(_body, -blow.impulseNs * ahead, arm);
    if (blow.breaks) _obstacles.breakDown(number);
    _obstacles.note({_timeS + kStepS, number, speedMps, place, motion.velocity, blow.breaks});
}

} // namespace simulation
