// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "simulation/parser/RandomDraw.h"
#include "simulation/player/GroundContact.h"
#include "simulation/player/PositionSolver.h"
#include "simulation/player/SceneFrame.h"
#include "simulation/player/SpeedProfile.h"
#include "simulation/player/TrajectoryRun.h"
#include "simulation/road/WayAhead.h"
#include "simulation/scenario/Entity.h"
#include "simulation/state/EntityState.h"

namespace simulation
{

/// Moves one entity along its trajectory, or straight ahead without one, at the speed given by its last speed
/// action or by the times of the trajectory. An entity that is not airborne stands on the ground where the
/// scene has ground. An airborne entity banks as a coordinated turn requires, tan(bank) = v²κ/g, up to 60°,
/// and pitches along its path, unless the vertices give these angles. A trajectory with times sets the speed
/// while it runs; afterwards the entity keeps its last motion. On a road network an entity without trajectory
/// keeps its lane and its offset from the lane's middle, and moves in each step by the speed at the end of
/// the step, as esmini does; elsewhere the distance is the integral of the speed.
class EntityMotion
{
public:
    /// `roads`: null without a road network.
    EntityMotion(const ScenarioObject& object, const SceneFrame& frame, const RoadScene* roads);

    const EntityState& state() const { return _state; }

    void teleport(const Placement& placement, double timeS);

    /// Lets the entity stand in the next step, whatever its speed.
    void standForAStep() { _standsForAStep = true; }

    /// Sets the speed from now on; ends the speed action.
    void setSpeed(double speedMps, double timeS);

    /// Puts the entity onto a lane at its s, its heading turned to the left of the lane's direction in which
    /// it drives.
    void setLane(int lane, double offsetM, double turnRad);

    /// What a lane change leaves of the way of the next step.
    struct AlongLane
    {
        double share = 1.0;     ///< that goes along the lane, not sideways
        std::int64_t order = 0; ///< of the lane change among the actions of the entity: see takeOrder()
    };

    /// A speed action that began after the lane change sets the speed behind it in each step.
    void goAlong(const AlongLane& along) { _along = along; }

    /// Returns the number of an action that begins now.
    std::int64_t takeOrder() { return ++_lastTicket; }

    /// Puts the entity to another place on the road.
    void setPlace(const RoadPlace& place);

    /// Puts the entity where it is drawn to, at the speed of what draws it.
    void towTo(const glm::dvec3& position, double headingRad, double speedMps);

    /// Takes the state of what moves the entity in place of its actions; name and place on the road are found
    /// here.
    void takeState(const EntityState& state, double timeS);

    /// Goes on by itself after something else moved it, from where that has left it: along the rest of its
    /// trajectory from where that comes nearest, else along the middle of a lane
    /// (RoadScene::takeLaneAhead()), else straight on, level. It comes to the speed that is asked for at 2
    /// m/s²; a trajectory with times has its own.
    void goOn(double askedMps, double timeS);

    const RoadWay& way() const { return _way; }
    const std::optional<RandomDraw>& turns() const
    {
        return _turns;
    } ///< absent: by the way, else straight on

    void setWay(RoadWay way)
    {
        _way = std::move(way);
        _turns.reset();
    }

    /// Takes a road by chance wherever several follow, from now on.
    void turnAtRandom(const RandomDraw& draw)
    {
        _way.clear();
        _turns = draw;
    }

    void setAnimation(const std::string& part, double state) { _state.animations[part] = state; }
    bool isAirborne() const { return _isAirborne; }
    bool isOnTrajectory() const { return _run.has_value(); }

    /// The speed that the actions ask for, whoever moves the entity. Units: m/s.
    double askedSpeedAt(double timeS) const { return _speed.speedAt(timeS - _speedStartS); }

    /// Where it goes by itself from here: the rest of its trajectory, else its lane by its way, up to a
    /// length. Without either no points.
    WayAhead wayAhead(double lengthM) const;

    /// The way along the rest of its trajectory to a place: see TrajectoryRun::wayTo(). Nothing without one.
    std::optional<double> wayOnTrajectory(const glm::dvec3& place) const;

    /// Starts an action and returns its ticket for isDone() and cancel(). A new action of the same kind ends
    /// the one before.
    std::int64_t startSpeed(const SpeedAction& action, double timeS);
    std::int64_t startTrajectory(const FollowTrajectoryAction& action, double timeS);
    std::int64_t speedTicket() const { return _speedTicket; }

    bool isDone(std::int64_t ticket, double timeS) const;
    void cancel(std::int64_t ticket, double timeS);

    /// Advances the entity to a later time, by one step.
    void advanceTo(double timeS, double stepS);

private:
    void followTrajectory(double timeS, double distanceM);
    void goStraight(double distanceM);
    void goAlongLane(double distanceM, double timeS);
    double roadStepM(double timeS, double stepS) const;
    void standOnRoad();
    void findPlace();
    void standOnGroundFarFromRoads();
    void takePoint(const PathPoint& point, double speedMps);
    void settle(double timeS);

    const SceneFrame* _frame;
    const RoadScene* _roads;
    GroundContact _contact;
    bool _isAirborne;
    double _mostAccelerationMps2 = 0.0, _mostDecelerationMps2 = 0.0, _mostSpeedMps = 0.0; ///< 0: no limit
    double _wheelRadiusM = 0.0;
    double _wheelbaseM = 0.0;
    double _givenPitchDeg = 0.0, _givenRollDeg = 0.0; ///< of the last teleport, beyond those of the road
    RoadWay _way;
    std::optional<RandomDraw> _turns; ///< absent: by the way, else straight on
    bool _standsForAStep = false;
    std::optional<AlongLane> _along; ///< in the next step
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
