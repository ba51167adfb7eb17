// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/ScenarioCheck.h"

#include <cstdio>
#include <optional>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

#include "simulation/player/TrajectoryRun.h"
#include "simulation/scenario/VisitActions.h"

namespace simulation
{
namespace
{

/// Walks a scenario and keeps the first thing that stands against playing it, and what refers to nothing.
class Walk
{
public:
    Walk(const Scenario& scenario, const SceneFrame& frame, const std::string& name, const RoadScene* roads)
        : _scenario(scenario), _frame(frame), _name(name), _roads(roads)
    {
    }

    foundation::Result<std::vector<foundation::Error>> run()
    {
        _isInit = true;
        for (const InitPrivate& initial : _scenario.storyboard.init.privates)
        {
            entity(initial.entity, initial.source);
            for (const PrivateAction& content : initial.actions)
                action(content);
        }
        _isInit = false;
        for (const GlobalAction& content : _scenario.storyboard.init.globals)
            globalAction(content);
        for (const Story& story : _scenario.storyboard.stories)
        {
            _names.insert({StoryboardElementType::story, story.name});
            for (const Act& content : story.acts)
                act(content);
        }
        trigger(_scenario.storyboard.stopTrigger);
        for (const auto& [condition, line] : _references)
            reference(*condition, line);
        lookAtSignals();
        if (_error) return *_error;
        return std::move(_warnings);
    }

private:
    using Name = std::pair<StoryboardElementType, std::string>;

    void act(const Act& content)
    {
        _names.insert({StoryboardElementType::act, content.name});
        trigger(content.startTrigger);
        trigger(content.stopTrigger);
        for (const ManeuverGroup& group : content.groups)
        {
            _names.insert({StoryboardElementType::maneuverGroup, group.name});
            for (const std::string& actor : group.actors)
                entity(actor, group.source);
            for (const Maneuver& maneuver : group.maneuvers)
            {
                _names.insert({StoryboardElementType::maneuver, maneuver.name});
                for (const Event& content2 : maneuver.events)
                    event(content2);
            }
        }
    }

    void event(const Event& content)
    {
        _names.insert({StoryboardElementType::event, content.name});
        trigger(content.startTrigger);
        for (const NamedAction& named : content.actions)
        {
            _names.insert({StoryboardElementType::action, named.name});
            if (const auto* privateAction = std::get_if<PrivateAction>(&named.action)) action(*privateAction);
            if (const auto* global = std::get_if<GlobalAction>(&named.action)) globalAction(*global);
        }
    }

    void action(const PrivateAction& content)
    {
        if (const auto* change = std::get_if<LaneChangeAction>(&content))
        {
            onLanes(change->source);
            if (_roads && change->entity.empty() && !isAnyLane(change->lane))
                warn(change->source, "no road has a lane " + std::to_string(change->lane),
                     "nothing is done; write the id of a lane");
        }
        if (const auto* offset = std::get_if<LaneOffsetAction>(&content)) onLanes(offset->source);
        if (const auto* teleport = std::get_if<TeleportAction>(&content))
        {
            const bool isGeo = std::holds_alternative<GeoPosition>(teleport->position);
            if (isGeo && !_frame.canPlace(teleport->position))
                fail(teleport->source, "a GeoPosition, but the scene has no georeference",
                     "use WorldPosition");
            onRoads(teleport->position, kNotPlaced);
        }
        if (const auto* acquire = std::get_if<AcquirePositionAction>(&content))
            onRoads(acquire->position, "nothing is done");
        if (const auto* assign = std::get_if<AssignRouteAction>(&content)) onRoute(assign->route);
        if (const auto* together = std::get_if<SynchronizeAction>(&content))
            for (const Position* position : {&together->masterPosition, &together->position})
                onRoads(*position, "nothing is done");
        if (const auto* follow = std::get_if<FollowTrajectoryAction>(&content))
        {
            onTrajectory(follow->trajectory.shape);
            const std::optional<std::string> obstacle = TrajectoryRun::obstacle(*follow, _frame);
            if (obstacle && isSupported(*follow))
                fail(follow->source,
                     "the trajectory " + follow->trajectory.name + " cannot be run: " + *obstacle,
                     "correct its vertices");
        }
    }

    void globalAction(const GlobalAction& content)
    {
        if (const auto* state = std::get_if<TrafficSignalStateAction>(&content))
            _signals.insert(state->signal);
        if (const auto* traffic = std::get_if<TrafficAction>(&content)) onTraffic(*traffic);
    }

    /// Looks for traffic that would not be there.
    void onTraffic(const TrafficAction& traffic)
    {
        const std::string nobody = "no vehicle appears", all = "no vehicle vanishes";
        if (const auto* source = std::get_if<TrafficSource>(&traffic.content))
        {
            onRoads(source->position, nobody);
            if (source->perSecond == 0.0)
                warn(traffic.source, "a TrafficSourceAction has the rate 0",
                     nobody + "; write how many appear in a second");
        }
        if (const auto* sink = std::get_if<TrafficSink>(&traffic.content))
        {
            onRoads(sink->position, all);
            if (sink->perSecond == 0.0)
                warn(traffic.source, "a TrafficSinkAction has the rate 0",
                     all + "; leave the rate out, or write how many vanish in a second");
        }
        const auto* swarm = std::get_if<TrafficSwarm>(&traffic.content);
        const auto* area = std::get_if<TrafficArea>(&traffic.content);
        if ((swarm && swarm->count == 0) || (area && area->count == 0))
            warn(traffic.source, "a traffic action asks for 0 vehicles", nobody + "; write how many");
        if (swarm && swarm->innerRadiusM >= swarm->semiMajorM)
            warn(traffic.source, "the innerRadius of a TrafficSwarmAction is not within its ellipse",
                 nobody + "; make semiMajorAxis the larger one");
        if (area)
            for (const RoadStretch& stretch : area->stretches)
                (void)onRoad(stretch.roadId, stretch.fromM, traffic.source, nobody + " there");
    }

    /// Looks at the places of a trajectory; without one of them it is not followed.
    void onTrajectory(const TrajectoryShape& shape)
    {
        const std::string instead = "the trajectory is not followed";
        if (const auto* line = std::get_if<Polyline>(&shape))
            for (const Vertex& vertex : line->vertices)
                onRoads(vertex.position, instead);
        if (const auto* clothoid = std::get_if<Clothoid>(&shape)) onRoads(clothoid->start, instead);
        if (const auto* nurbs = std::get_if<Nurbs>(&shape))
            for (const Nurbs::ControlPoint& point : nurbs->points)
                onRoads(point.position, instead);
    }

    bool isAnyLane(int lane) const
    {
        for (const auto& road : _roads->network().roads)
            for (const auto& section : road.sections)
                for (const auto* side : {&section.left, &section.right})
                    for (const auto& one : *side)
                        if (one.id == lane) return true;
        return false;
    }

    void onLanes(SourceLine source)
    {
        if (!_roads)
            warn(source, "an action on lanes, but there are no roads",
                 "nothing is done; name the OpenDRIVE file in LogicFile");
    }

    /// Looks whether a place lies on roads that there are. `instead`: what is done where it does not.
    template<class Place>
    void onRoads(const Place& position, const std::string& instead)
    {
        if (const auto* lane = std::get_if<LanePosition>(&position)) onLane(*lane, instead);
        if (const auto* road = std::get_if<RoadPosition>(&position))
            onRoad(road->roadId, road->sM, road->source, instead);
        if constexpr (std::is_same_v<Place, Position>)
            if (const auto* on = std::get_if<RoutePosition>(&position)) onRoute(on->route);
    }

    void onRoute(const Route& route)
    {
        for (const FixedPosition& waypoint : route.waypoints)
            onRoads(waypoint, "the route leaves it out");
    }

    /// Whether there is the road.
    bool onRoad(const std::string& id, double sM, SourceLine source, const std::string& instead)
    {
        const int index = _roads ? _roads->network().roadIndex(id) : -1;
        if (!_roads) return false;
        if (index < 0)
        {
            missing(source, "the road " + id + " does not exist", instead,
                    "write the id of a road of the LogicFile");
            return false;
        }
        constexpr double kBeyondM = 1.0; // lengths are rounded
        const double lengthM = _roads->network().roads[static_cast<std::size_t>(index)].length;
        if (sM < -kBeyondM || sM > lengthM + kBeyondM)
            warn(source,
                 "s " + metres(sM) + " is beyond the road " + id + ", which is " + metres(lengthM) + " long",
                 "the end of the road is taken; write an s on it");
        return true;
    }

    static std::string metres(double value)
    {
        char text[32];
        std::snprintf(text, sizeof text, "%.6g m", value);
        return text;
    }

    void onLane(const LanePosition& position, const std::string& instead)
    {
        if (!onRoad(position.roadId, position.sM, position.source, instead)) return;
        if (!_roads->onLane(position.roadId, position.lane, position.sM, 0.0))
            missing(position.source,
                    "the road " + position.roadId + " has no lane " + std::to_string(position.lane) +
                        " at this s",
                    instead, "write the id of a lane there");
    }

    static bool isSupported(const FollowTrajectoryAction& follow)
    {
        const auto* polyline = std::get_if<Polyline>(&follow.trajectory.shape);
        if (!polyline) return false;
        for (const Vertex& vertex : polyline->vertices)
            if (!std::holds_alternative<WorldPosition>(vertex.position) &&
                !std::holds_alternative<GeoPosition>(vertex.position))
                return false; // on roads, or relative to entities: known when it begins
        return true;
    }

    void trigger(const std::optional<Trigger>& content)
    {
        if (!content) return;
        for (const ConditionGroup& group : content->groups)
            for (const Condition& condition : group.conditions)
                if (const auto* entity = std::get_if<EntityCondition>(&condition.content))
                    onCondition(*entity);
                else if (const auto* state = std::get_if<StoryboardElementStateCondition>(&condition.content))
                    _references.emplace_back(state, condition.source);
                else if (const auto* signal = std::get_if<TrafficSignalCondition>(&condition.content))
                    _lookedAt.emplace_back(signal->signal, condition.source);
    }

    void onCondition(const EntityCondition& condition)
    {
        const std::string instead = "the condition is never true";
        const auto onTarget = [&](const std::variant<std::string, Position>& target)
        {
            if (const auto* place = std::get_if<Position>(&target)) onRoads(*place, instead);
        };
        if (const auto* reach = std::get_if<ReachPositionCondition>(&condition.content))
            onRoads(reach->position, instead);
        if (const auto* distance = std::get_if<DistanceCondition>(&condition.content))
            onTarget(distance->target);
        if (const auto* collision = std::get_if<TimeToCollisionCondition>(&condition.content))
            onTarget(collision->target);
    }

    /// Whether anything sets the signals that conditions ask for.
    void lookAtSignals()
    {
        for (const TrafficSignalController& controller : _scenario.roadNetwork.signalControllers)
            for (const SignalPhase& phase : controller.phases)
                for (const auto& [signal, state] : phase.states)
                    _signals.insert(signal);
        for (const auto& [signal, source] : _lookedAt)
            if (!_signals.contains(signal))
                warn(source, "no controller and no action sets the traffic signal " + signal,
                     "the condition is never true; correct its name");
    }

    void reference(const StoryboardElementStateCondition& condition, SourceLine source)
    {
        const std::size_t colon = condition.element.rfind("::");
        const std::string name =
            colon == std::string::npos ? condition.element : condition.element.substr(colon + 2);
        if (!_names.contains(Name(condition.type, name)))
            warn(source, "the storyboard element " + condition.element + " does not exist",
                 "the condition is never true; correct the reference");
    }

    void entity(const std::string& name, SourceLine source)
    {
        if (_scenario.entityIndex(name) < 0)
            fail(source, "the entity " + name + " does not exist", "correct the name");
    }

    void fail(SourceLine source, const std::string& what, const std::string& remedy)
    {
        if (!_error) _error = foundation::Error{_name + ":" + std::to_string(source.line), what, remedy};
    }

    /// A place that is not there: in Init, where the entity would stand at the origin for all of the play, it
    /// is a fault.
    void missing(SourceLine source, const std::string& what, const std::string& instead,
                 const std::string& remedy)
    {
        if (_isInit && instead == kNotPlaced)
            fail(source, what, remedy);
        else
            warn(source, what, instead + "; " + remedy);
    }

    void warn(SourceLine source, const std::string& what, const std::string& instead)
    {
        _warnings.push_back({_name + ":" + std::to_string(source.line), what, "instead: " + instead});
    }

    const Scenario& _scenario;
    const SceneFrame& _frame;
    const std::string& _name;
    const RoadScene* _roads;
    static constexpr const char* kNotPlaced = "the entity is not placed";
    bool _isInit = false; ///< what is walked through is Init
    std::set<Name> _names;
    std::vector<std::pair<const StoryboardElementStateCondition*, SourceLine>> _references;
    std::set<std::string> _signals; ///< that something sets
    std::vector<std::pair<std::string, SourceLine>> _lookedAt;
    std::optional<foundation::Error> _error;
    std::vector<foundation::Error> _warnings;
};

} // namespace

foundation::Result<std::vector<foundation::Error>> checkPlayable(const Scenario& scenario,
                                                                 const SceneFrame& frame,
                                                                 const std::string& name,
                                                                 const RoadScene* roads)
{
    return Walk(scenario, frame, name, roads).run();
}

foundation::Outcome checkControllers(const Scenario& scenario, MotionSource& source, const std::string& name)
{
    foundation::Outcome sound = foundation::success();
    const auto look = [&](const Controller& controller, const ScenarioObject& object)
    {
        if (!sound || !controller.hasPhysics()) return;
        if (const auto usable = source.check(controller, object); !usable)
            sound = foundation::Error{name + ":" + std::to_string(controller.source.line) + ", controller " +
                                          controller.name + ", " + usable.error().place,
                                      usable.error().what, usable.error().remedy};
    };
    for (const ScenarioObject& object : scenario.entities)
        for (const Controller& controller : object.controllers)
            look(controller, object);
    const auto lookAt = [&](const PrivateAction& action, const std::string& actor)
    {
        const auto* assigned = std::get_if<AssignControllerAction>(&action);
        const int entity = assigned ? scenario.entityIndex(actor) : -1;
        if (entity >= 0) look(assigned->controller, scenario.entities[static_cast<std::size_t>(entity)]);
    };
    for (const InitPrivate& initial : scenario.storyboard.init.privates)
        for (const PrivateAction& action : initial.actions)
            lookAt(action, initial.entity);
    visitGroups(scenario,
                [&](const ManeuverGroup& group, const Action& action)
                {
                    const auto* own = std::get_if<PrivateAction>(&action);
                    for (const std::string& actor : group.actors)
                        if (own) lookAt(*own, actor);
                });
    return sound;
}

} // namespace simulation
