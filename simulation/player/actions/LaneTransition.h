// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/player/actions/RunningAction.h"

namespace simulation
{

/// Moves an entity sideways from its offset to another one, on the lane that it then belongs to, by a shape
/// over time or over distance. The entity turns into the direction in which it moves: the sine of the turn is
/// the speed sideways by its speed. A lane change (`isAhead`) has its turn of the beginning of the step, and
/// the way sideways is taken from the way along the lane; it goes sideways no faster than the entity moves,
/// and waits while that stands. Its distance counts along the lane. A change of the offset begins one step
/// later, and the way along the lane stays as it is. Both as in esmini. Where the entity comes to another
/// lane section or road, the lane and the side go on as they are linked.
class LaneTransition final : public RunningAction
{
public:
    struct Course
    {
        int lane = 0;
        double toOffsetM = 0.0;
        DynamicsShape shape = DynamicsShape::step;
        double duration = 0.0;     ///< seconds, or metres
        bool isByDistance = false; ///< duration counts metres that the entity moves
        bool isEndless = false;    ///< keeps the offset until another action begins
        bool isAhead = false;      ///< see above
        std::int64_t order = 0;    ///< of a lane change: see EntityMotion::takeOrder()
    };

    LaneTransition(const Course& course, const EntityMotion& actor, const RoadScene& roads);

    ActionDomain domain() const override { return ActionDomain::lateral; }
    bool step(ActionScene& scene, EntityMotion& actor) override;

private:
    void followLinks(const RoadPlace& place, const osgRoads::core::LaneSection* section);
    void turnTo(EntityMotion& actor, double offsetM, double turnRad);
    bool stepAhead(EntityMotion& actor, double stepS);
    bool stepOffset(EntityMotion& actor, double stepS);
    bool arrive(EntityMotion& actor);
    double now() const;
    double offsetNow() const;

    Course _course;
    double _fromOffsetM = 0.0;
    double _done = 0.0;
    bool _hasBegun = false;
    bool _isForward = true; ///< of the reference line, when it was last on the lane
    bool _isOnLane = false; ///< has been put there
    const osgRoads::core::LaneSection* _section = nullptr; ///< where it was then
};

/// Returns how long a change takes whose dynamics are given, `amount` being the size of the change; seconds
/// or metres.
double durationOf(const TransitionDynamics& dynamics, double amount);

} // namespace simulation
