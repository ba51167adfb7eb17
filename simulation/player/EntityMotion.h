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

/// Moves one entity along its trajectory, or straight ahead without one, at the speed given by its last speed action
/// or by the times of the trajectory. An entity that is not airborne stands on the ground where the scene has ground.
/// An airborne entity banks as a coordinated turn requires, tan(bank) = v²κ/g, up to 60°, and pitches along its path,
/// unless the vertices give these angles.
/// A trajectory with times sets the speed while it runs; afterwards the entity keeps its last motion.
class EntityMotion
{
public:
    EntityMotion(const ScenarioObject& object, const SceneFrame& frame);

    const EntityState& state() const { return _state; }

    void teleport(const Position& position, double timeS);

    /// Starts an action and returns its ticket for isDone() and cancel(). A new action of the same kind ends the one
    /// before.
    std::int64_t startSpeed(const SpeedAction& action, double timeS);
    std::int64_t startTrajectory(const FollowTrajectoryAction& action, double timeS);

    bool isDone(std::int64_t ticket, double timeS) const;
    void cancel(std::int64_t ticket, double timeS);

    /// Advances the entity to a later time.
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
