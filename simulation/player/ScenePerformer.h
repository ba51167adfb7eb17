// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "simulation/clock/FixedClock.h"
#include "simulation/player/Actor.h"
#include "simulation/player/ExternalControl.h"
#include "simulation/player/PositionSolver.h"
#include "simulation/player/SignalPlan.h"
#include "simulation/player/StoryboardRunner.h"
#include "simulation/player/Trailers.h"
#include "simulation/player/traffic/RoadTraffic.h"
#include "simulation/state/EnvironmentState.h"

namespace simulation
{

/// The entities of a scenario and everything else that actions change; it performs the storyboard's actions.
class ScenePerformer final : public ActionPerformer, public TrafficScene
{
public:
    /// What it works on; all must outlive it. `roads` may be null.
    struct Place
    {
        const Scenario& scenario;
        const SceneFrame& frame;
        const RoadScene* roads;
        const FixedClock& clock;
        EnvironmentClock& environment;
        const TrafficPlan& traffic;
        std::uint64_t seed;
        std::shared_ptr<MotionSource> motionSource{}; ///< null: controllers with physics move nothing
    };

    explicit ScenePerformer(const Place& place);

    /// The entities that vehicles with physics move.
    ExternalControl& external() { return _external; }
    const ExternalControl& external() const { return _external; }

    /// Lets lent entities begin where they stand; after performInit(). Errors: one cannot.
    foundation::Outcome beginExternal();

    /// Performs the actions of Init: those of all entities that place something first, because positions may
    /// refer to entities that stand further down.
    void performInit();

    /// Lets persons take over and give back what they sit in, before the clock advances.
    void turn();

    /// Carries running actions on to the time of the clock.
    void carryOn();

    /// Moves the entities on to the time of the clock.
    void move();

    const std::vector<EntityState>& states() const { return _published; }
    const std::map<std::string, std::string>& values() const { return _values; }
    const SignalPlan& signals() const { return _signals; }
    const std::map<std::string, bool>& monitors() const { return _monitors; }

    // ActionPerformer
    ActionTicket perform(const PrivateAction& action, const std::string& actor) override;
    void perform(const GlobalAction& action) override;
    bool isDone(const ActionTicket& ticket) const override;
    void cancel(const ActionTicket& ticket) override;

    // ActionScene
    double timeS() const override { return _clock->seconds(); }
    double stepS() const override { return _clock->stepS(); }
    const RoadScene* roads() const override { return _roads; }
    const PositionSolver& positions() const override { return _positions; }
    const Scenario& scenario() const override { return *_scenario; }
    EntityMotion& motion(int entity) override { return actorOf(entity).motion; }
    double grip() const override { return std::min(_environment->roadFriction(), 1.0); }
    bool isPresent(int entity) const override { return !_actors[static_cast<std::size_t>(entity)].isAbsent; }
    const std::map<std::string, std::string>& signalStates() const override { return _signals.states(); }
    Traffic trafficOf(int entity) const override
    {
        return {_published, _boxes, entity, &_signals.states(), &_environmentNow};
    }
    std::shared_ptr<JunctionKeeper> junctions() override;
    int find(const std::string& entity) const override { return _scenario->entityIndex(entity); }

    // TrafficScene
    void appear(int vehicle, const RoadPlace& place, double speedMps) override;
    void vanish(int vehicle) override;
    bool isTraffic(int entity) const override { return _traffic.plan().isTraffic(entity); }
    const std::vector<LaneSite>& laneSites() override;

private:
    struct Running
    {
        std::int64_t number;
        int actor;
        std::unique_ptr<RunningAction> action; ///< null: done
    };

    template<class Action>
    ActionTicket start(const Action& action, int actor, ActionDomain domain);
    void end(int actor, ActionDomain domain);
    // What each action does; a ticket of one that lasts.
    ActionTicket carryOut(const TeleportAction& action, int actor);
    ActionTicket carryOut(const FollowTrajectoryAction& action, int actor);
    ActionTicket carryOut(const SpeedAction& action, int actor);
    ActionTicket carryOut(const SpeedProfileAction& action, int actor);
    ActionTicket carryOut(const LongitudinalDistanceAction& action, int actor);
    ActionTicket carryOut(const LaneChangeAction& action, int actor);
    ActionTicket carryOut(const LaneOffsetAction& action, int actor);
    ActionTicket carryOut(const LateralDistanceAction& action, int actor);
    ActionTicket carryOut(const AssignRouteAction& action, int actor);
    ActionTicket carryOut(const AcquirePositionAction& action, int actor);
    ActionTicket carryOut(const SynchronizeAction& action, int actor);
    ActionTicket carryOut(const ActivateControllerAction& action, int actor);
    ActionTicket carryOut(const AssignControllerAction& action, int actor);
    ActionTicket carryOut(const VisibilityAction& action, int actor);
    ActionTicket carryOut(const LightStateAction& action, int actor);
    ActionTicket carryOut(const TrailerAction& action, int actor);
    ActionTicket carryOut(const AnimationAction& action, int actor);
    ActionTicket carryOut(const OverrideAction& action, int actor);
    ActionTicket carryOut(const RandomRouteAction& action, int actor);
    ActionTicket carryOut(const Unsupported&, int) { return {}; }
    void carryOut(const EnvironmentAction& action);
    void carryOut(const SetValueAction& action);
    void carryOut(const SetMonitorAction& action);
    void carryOut(const TrafficSignalStateAction& action);
    void carryOut(const TrafficSignalControllerAction& action);
    void carryOut(const EntityAction& action);
    void carryOut(const TrafficAction& action) { _traffic.begin(action); }
    void carryOut(const Unsupported&) {}

    Actor& actorOf(int entity) { return _actors[static_cast<std::size_t>(entity)]; }
    const Controller* controllerOf(const std::string& name, int actor) const;
    void activate(const std::string& controller, const ExternalControl::Wish& wish, int actor);
    bool isHeld(const PrivateAction& action, int actor);
    void moveControlled();
    void collide();
    std::optional<RoadPlace> laneUnder(const EntityState& state) const;
    void publish();
    void moveExternal();
    void askExternal(std::size_t entity);
    std::optional<glm::dvec3> askedPlace(std::size_t entity) const;
    void goOn(std::size_t entity);
    void leadGivenBack();
    bool asksPerson(const Controller& controller, const ExternalControl::Wish& wish, int actor);

    const Scenario* _scenario;
    const SceneFrame* _frame;
    const RoadScene* _roads;
    const FixedClock* _clock;
    EnvironmentClock* _environment;
    EnvironmentState _environmentNow; ///< when vehicles with physics moved last
    std::vector<Actor> _actors;       ///< of the scenario's entities, in their order
    ExternalControl _external;
    std::vector<EntityState> _published; ///< what all see of the actors until the end of the next step
    std::vector<BoundingBox> _boxes;     ///< of the same
    std::vector<double> _reachesM;       ///< of the same, around the reference point
    PositionSolver _positions;
    std::vector<Running> _running;
    std::int64_t _lastNumber = 0;
    std::map<std::string, std::string> _values;
    SignalPlan _signals;
    std::map<std::string, bool> _monitors;
    Trailers _trailers;
    RoadTraffic _traffic;
    std::shared_ptr<JunctionKeeper> _junctions;      ///< made when somebody asks for it
    std::optional<std::vector<LaneSite>> _laneSites; ///< made when traffic asks for them
    std::uint64_t _drawn = 0;                        ///< series of random numbers so far
};

} // namespace simulation
