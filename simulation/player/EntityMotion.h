// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "simulation/player/EntityState.h"
#include "simulation/player/GroundContact.h"
#include "simulation/player/SceneFrame.h"
#include "simulation/player/SpeedProfile.h"
#include "simulation/player/TrajectoryRun.h"
#include "simulation/scenario/Entity.h"

namespace simulation
{

/// Moves one entity: along a trajectory where it has one, else straight ahead, at the speed that its last speed action
/// or the trajectory's times ask for. An entity that is not airborne stands on the ground wherever the scene has one.
/// An airborne one banks as a coordinated turn demands, tan(bank) = v²κ/g, up to 60°, and pitches along its path,
/// unless the vertices say otherwise.
/// A timed trajectory rules the speed while it runs; afterwards the entity goes on as it last moved.
class EntityMotion
{
public:
    EntityMotion(const ScenarioObject& object, const SceneFrame& frame);

    const EntityState& state() const { return _state; }

    void teleport(const Position& position, double timeS);

    /// Ticket of the action, for isDone() and cancel(). A new action of the same kind ends the one before.
    std::int64_t startSpeed(const SpeedAction& action, double timeS);
    std::int64_t startTrajectory(const FollowTrajectoryAction& action, double timeS);

    bool isDone(std::int64_t ticket, double timeS) const;
    void cancel(std::int64_t ticket, double timeS);

    /// Moves on to a later time.
    void advanceTo(double timeS);

private:
    void followTrajectory(double timeS, double distanceM);
    void goStraight(double distanceM);
    void takePoint(const PathPoint& point, double speedMps);
    void settle(double timeS);

    const SceneFrame* _frame;
    GroundContact _contact;
    bool _isAirborne;
    double _wheelRadiusM = 0.0;
    double _wheelbaseM = 0.0;
    EntityState _state;
    double _timeS = 0.0;
    SpeedProfile _speed;
    double _speedStartS = 0.0;
    std::int64_t _speedTicket = 0;
    std::optional<TrajectoryRun> _run;
    std::int64_t _runTicket = 0;
    std::int64_t _lastTicket = 0;
};

} // namespace simulation
