// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/HullMeeting.h"

#include <algorithm>
#include <cmath>

namespace simulation
{

HullPlan hullPlanOf(const HullBox& box, const glm::dvec3& centre, const SolidMotion& motion)
{
    const glm::dmat3 body = glm::mat3_cast(motion.bodyToScene);
    const glm::dvec3 middle = motion.position + motion.bodyToScene * (box.place - centre);
    const glm::dvec3 half = 0.5 * box.sizeM;
    HullPlan plan;
    plan.middle = glm::dvec2(middle);
    const double level = glm::length(glm::dvec2(body[0]));
    if (level > 1e-6) plan.along = glm::dvec2(body[0]) / level;
    const glm::dvec2 left(-plan.along.y, plan.along.x);
    const auto reach = [&](const glm::dvec2& axis)
    {
        return half.x * std::abs(glm::dot(glm::dvec2(body[0]), axis)) +
               half.y * std::abs(glm::dot(glm::dvec2(body[1]), axis)) +
               half.z * std::abs(glm::dot(glm::dvec2(body[2]), axis));
    };
    plan.halfM = {reach(plan.along), reach(left)};
    const double high =
        half.x * std::abs(body[0].z) + half.y * std::abs(body[1].z) + half.z * std::abs(body[2].z);
    plan.lowM = middle.z - high;
    plan.highM = middle.z + high;
    return plan;
}

bool HullMeeting::look(const SolidMotion& motion, double timeS, double stepS)
{
    _touchedMovers.clear();
    _isNear = false;
    _timeS = timeS;
    _stepS = stepS;
    if (!_obstacles.hasMap() && _obstacles.movers().empty() && !_hasMovers) return false;
    double reachM = kLookFurtherM + glm::length(motion.velocity) * stepS;
    double hullM = 0.0;
    for (const HullBox& box : _body.hull->boxes)
        hullM = std::max(hullM, glm::length(box.place - _body.centre) + 0.5 * glm::length(box.sizeM));
    reachM += hullM;
    bool isStruck = lookAtMovers(motion, reachM);
    if (_obstacles.hasMap())
    {
        const glm::dvec2 middle(motion.position);
        _obstacles.look(middle - reachM, middle + reachM);
        _body.world->stand(_body.number, _obstacles.map(), _obstacles.fast());
        for (const std::uint32_t number : _obstacles.giving())
            meetGiving(_obstacles.map().at(number), number, motion);
        isStruck = isStruck || !_obstacles.giving().empty();
        _isNear = !_obstacles.fast().empty();
    }
    _isNear = _isNear || _hasMovers;
    return isStruck;
}

/// Vehicles become bodies that go on as they do; persons give way. Returns whether some of those are near.
bool HullMeeting::lookAtMovers(const SolidMotion& motion, double reachM)
{
    bool isStruck = false;
    std::vector<MovingObstacle> fast;
    for (const MovingObstacle& mover : _obstacles.movers())
    {
        const double farthestM = reachM + glm::length(mover.box.halfM) + glm::length(mover.velocity) * _stepS;
        if (glm::distance(mover.box.middle, glm::dvec2(motion.position)) > farthestM) continue;
        if (standsFast(mover.box.kind))
            fast.push_back(mover);
        else if (!_obstacles.isBroken(mover))
        {
            meetGiving(mover.box, ObstacleMeeting::numberOf(mover.number), motion);
            isStruck = true;
        }
    }
    if (!fast.empty() || _hasMovers) _body.world->accompany(fast);
    _hasMovers = !fast.empty();
    return isStruck;
}

void HullMeeting::note(const SolidHit& hit, double timeS, const glm::dvec3& velocity)
{
    if (hit.obstacle) _obstacles.note({timeS, *hit.obstacle, hit.obstacleMps, hit.place, velocity, false});
    if (hit.mover)
        _obstacles.note(
            {timeS, ObstacleMeeting::numberOf(*hit.mover), hit.moverMps, hit.moverPlace, velocity, false});
    for (const int mover : hit.movers)
    {
        const auto at = std::lower_bound(_touchedMovers.begin(), _touchedMovers.end(), mover);
        if (at == _touchedMovers.end() || *at != mover) _touchedMovers.insert(at, mover);
    }
}

void HullMeeting::meetGiving(const Obstacle& obstacle, std::uint32_t number, const SolidMotion& looked)
{
    const std::vector<HullBox>& boxes = _body.hull->boxes;
    const auto touching = std::find_if(boxes.begin(), boxes.end(),
                                       [&](const HullBox& box)
                                       { return overlaps(hullPlanOf(box, _body.centre, looked), obstacle); });
    if (touching == boxes.end()) return;
    if (number >= ObstacleMeeting::kMovers)
        _touchedMovers.push_back(static_cast<int>(number - ObstacleMeeting::kMovers));
    const HullPlan plan = hullPlanOf(*touching, _body.centre, looked);
    const SolidMotion motion = _body.world->motion(_body.number);
    const glm::dvec3 place(
        glm::clamp(obstacle.middle, plan.middle - plan.halfM.x, plan.middle + plan.halfM.x),
        std::clamp(motion.position.z, obstacle.lowM, obstacle.highM));
    const glm::dvec3 arm = place - motion.position;
    glm::dvec3 velocity = motion.velocity + glm::cross(motion.rates, arm);
    velocity.z = 0.0;
    const double speedMps = glm::length(velocity);
    if (speedMps < 1e-3 || glm::dot(glm::dvec2(velocity), obstacle.middle - plan.middle) <= 0.0) return;
    const glm::dvec3 ahead = velocity / speedMps;
    const GivingBlow blow = blowOf(obstacle.kind, speedMps, _body.massKg,
                                   _body.world->inverseMassAt(_body.number, arm, ahead), _stepS);
    _body.world->strike(_body.number, -blow.impulseNs * ahead, arm);
    if (blow.breaks) _obstacles.breakDown(number);
    _obstacles.note({_timeS, number, speedMps, place, motion.velocity, blow.breaks});
}

} // namespace simulation
