// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/ScenePerformer.h"

#include <algorithm>
#include <cmath>

#include "simulation/player/EntityDistance.h"
#include "simulation/scenario/VisitActions.h"

namespace simulation
{

namespace
{

constexpr double kInstantS = 1e-9;
constexpr double kWayM = 20'000.0; ///< that a driver knows when a controller begins

/// An entity that is added by an action of the story, and that Init does nothing with, is not there before.
std::vector<bool> absentAtFirst(const Scenario& scenario)
{
    std::vector<bool> absent(scenario.entities.size(), false);
    const auto mark = [&](const std::string& name, bool isAbsent)
    {
        const int entity = scenario.entityIndex(name);
        if (entity >= 0) absent[static_cast<std::size_t>(entity)] = isAbsent;
    };
    visitActions(scenario,
                 [&](const Action& action)
                 {
                     const auto* global = std::get_if<GlobalAction>(&action);
                     const auto* entity = global ? std::get_if<EntityAction>(global) : nullptr;
                     if (entity && !entity->isDeleted) mark(entity->entity, true);
                 });
    for (const InitPrivate& initial : scenario.storyboard.init.privates)
        mark(initial.entity, false);
    return absent;
}

} // namespace

ScenePerformer::ScenePerformer(const Place& place)
    : _scenario(&place.scenario),
      _frame(&place.frame),
      _roads(place.roads),
      _clock(&place.clock),
      _environment(&place.environment),
      _external({place.scenario, _motions, [this] { return _environment->at(timeS()); },
                 [](const EntityMotion& motion) { return motion.wayAhead(kWayM); },
                 [this](std::size_t entity) { return !_isAbsent[entity]; }},
                place.motionSource),
      _positions(place.frame, place.roads,
                 [this](const std::string& entity) -> const EntityState*
                 {
                     const int index = find(entity);
                     return index < 0 ? nullptr : &_motions[static_cast<std::size_t>(index)].state();
                 }),
      _signals(place.scenario.roadNetwork.signalControllers),
      _trailers(place.scenario),
      _traffic(place.traffic, place.seed),
      _isAbsent(absentAtFirst(place.scenario)),
      _isHidden(place.scenario.entities.size(), false),
      _active(place.scenario.entities.size()),
      _controls(place.scenario.entities.size()),
      _pedals(place.scenario.entities.size()),
      _lamps(place.scenario.entities.size())
{
    const Scenario& scenario = place.scenario;
    for (int i = 0; i < static_cast<int>(scenario.entities.size()); ++i)
        if (isTraffic(i)) _isAbsent[static_cast<std::size_t>(i)] = true;
    for (const ScenarioObject& object : scenario.entities)
    {
        _motions.emplace_back(object, place.frame, place.roads);
        _boxes.push_back(object.box());
        _controllers.push_back(object.controllers);
    }
    for (const ParameterDeclaration& parameter : scenario.parameters)
        _values[parameter.name] = parameter.value;
    for (const ParameterDeclaration& variable : scenario.variables)
        _values[variable.name] = variable.value;
    for (const MonitorDeclaration& monitor : scenario.monitors)
        _monitors[monitor.name] = monitor.value;
    publish();
}

void ScenePerformer::performInit()
{
    for (const GlobalAction& action : _scenario->storyboard.init.globals)
        perform(action);
    for (const InitPrivate& initial : _scenario->storyboard.init.privates)
        for (const PrivateAction& action : initial.actions)
            perform(action, initial.entity);
    _trailers.align(_motions);
    _traffic.step(*this);
    publish();
}

void ScenePerformer::carryOn()
{
    for (std::size_t i = 0; i < _running.size(); ++i)
    {
        Running& running = _running[i];
        if (running.action && running.action->step(*this, motion(running.actor))) running.action.reset();
    }
    std::erase_if(_running, [](const Running& running) { return !running.action; });
}

void ScenePerformer::move()
{
    _signals.advanceTo(timeS());
    for (std::size_t i = 0; i < _motions.size(); ++i)
        if (!_external.has(i) && !driverOf(i) && !_isAbsent[i])
            _motions[i].advanceTo(timeS(), _clock->stepS());
    moveControlled();
    moveExternal();
    std::erase_if(_givenBack, [this](const auto& one) { return one.second.isOver(timeS()); });
    _trailers.follow(_motions);
    _traffic.step(*this);
    publish();
}

foundation::Outcome ScenePerformer::beginExternal()
{
    auto begun = _external.beginAll();
    publish();
    return begun;
}

/// They see the others where they are now, as in esmini.
void ScenePerformer::moveControlled()
{
    for (std::size_t i = 0; i < _motions.size(); ++i)
    {
        SpeedController* const driver = driverOf(i);
        if (_external.has(i) || !driver || _isAbsent[i]) continue;
        _motions[i].setSpeed(driver->speedAfter(*this, static_cast<int>(i)), timeS());
        _motions[i].advanceTo(timeS(), _clock->stepS());
    }
}

/// All see the others as they were before.
void ScenePerformer::moveExternal()
{
    const EnvironmentState environment = _environment->at(timeS());
    _external.advanceTo(
        timeS(),
        [&](std::size_t entity) {
            return Traffic{_states, _boxes, static_cast<int>(entity), &_signals.states(), &environment};
        },
        [this](std::size_t entity) { return askedPlace(entity); });
}

/// Where a lateral action that runs has put the entity.
std::optional<glm::dvec3> ScenePerformer::askedPlace(std::size_t entity) const
{
    const bool isMoved = std::any_of(_running.begin(), _running.end(),
                                     [&](const Running& running)
                                     {
                                         return running.action && running.actor == static_cast<int>(entity) &&
                                                running.action->domain() == ActionDomain::lateral;
                                     });
    const EntityState& state = _motions[entity].state();
    if (!isMoved || !_roads || !state.place) return std::nullopt;
    return _roads->poseAt(*state.place).position;
}

/// Pedals come before a controller.
SpeedController* ScenePerformer::driverOf(std::size_t entity) const
{
    return _pedals[entity] ? _pedals[entity].get() : _active[entity].get();
}

std::optional<RoadPlace> ScenePerformer::laneUnder(const EntityState& state) const
{
    if (!_roads || !state.place) return std::nullopt;
    RoadPlace under = *state.place;
    _roads->takeNearestLane(under);
    return under;
}

void ScenePerformer::publish()
{
    const std::vector<EntityState> before = std::move(_states);
    _states.clear();
    for (const EntityMotion& motion : _motions)
        _states.push_back(motion.state());
    leadGivenBack();
    for (std::size_t i = 0; i < _states.size(); ++i)
    {
        _states[i].isPresent = !_isAbsent[i];
        _states[i].laneUnder = laneUnder(_states[i]);
        _states[i].isVisible = !_isAbsent[i] && !_isHidden[i];
        for (auto& [name, lamp] : _lamps[i])
        {
            const double period = lamp.onS + lamp.offS;
            const double since = timeS() - lamp.sinceS;
            lamp.isLit = lamp.mode == LightMode::on ||
                         (lamp.mode == LightMode::flashing &&
                          (period <= 0.0 || std::fmod(since + kInstantS, period) < lamp.onS));
        }
        for (const auto& [name, lamp] : _lamps[i]) // over those of its own physics
            _states[i].lamps[name] = lamp;
    }
    for (std::size_t i = 0; i < _states.size() && i < before.size(); ++i)
        _states[i].acceleration = (_states[i].velocity - before[i].velocity) / _clock->stepS();
    collide();
}

void ScenePerformer::collide()
{
    const auto body = [&](std::size_t index) {
        return MeasuredBody{&_states[index], _scenario->entities[index].box()};
    };
    for (std::size_t i = 0; i < _states.size(); ++i)
        for (std::size_t j = i + 1; !_isAbsent[i] && j < _states.size(); ++j)
            if (!_isAbsent[j] && overlap(body(i), body(j)))
            {
                _states[i].collidesWith.push_back(static_cast<int>(j));
                _states[j].collidesWith.push_back(static_cast<int>(i));
            }
    // A body that was kept out of a box touches it all the same.
    const auto meet = [this](int one, int other)
    {
        std::vector<int>& met = _states[static_cast<std::size_t>(one)].collidesWith;
        const auto at = std::lower_bound(met.begin(), met.end(), other);
        if (at == met.end() || *at != other) met.insert(at, other);
    };
    for (const auto& [one, other] : _external.touches())
    {
        meet(one, other);
        meet(other, one);
    }
}

void ScenePerformer::end(int actor, ActionDomain domain)
{
    for (Running& running : _running)
        if (running.actor == actor && running.action && running.action->domain() == domain)
            running.action.reset();
}

ActionTicket ScenePerformer::perform(const PrivateAction& action, const std::string& actorName)
{
    const int actor = find(actorName);
    if (actor < 0 || _isAbsent[static_cast<std::size_t>(actor)] || isHeld(action, actor)) return {};
    return std::visit([&](const auto& content) { return carryOut(content, actor); }, action);
}

void ScenePerformer::perform(const GlobalAction& action)
{
    std::visit([&](const auto& content) { carryOut(content); }, action);
}

void ScenePerformer::appear(int vehicle, const RoadPlace& place, double speedMps)
{
    const auto index = static_cast<std::size_t>(vehicle);
    const RoadPose pose = _roads->poseAt(place);
    motion(vehicle).setSpeed(speedMps, timeS());
    motion(vehicle).teleport({pose.position, pose.headingRad, 0.0, 0.0, true, place}, timeS());
    motion(vehicle).turnAtRandom(RandomDraw(_traffic.seed(), _scenario->entities[index].name, ++_drawn));
    _isAbsent[index] = false;
    activate("", {true, true}, vehicle);
}

void ScenePerformer::vanish(int vehicle)
{
    for (const ActionDomain domain : {ActionDomain::longitudinal, ActionDomain::lateral})
        end(vehicle, domain);
    _active[static_cast<std::size_t>(vehicle)].reset();
    _external.vanish(static_cast<std::size_t>(vehicle), timeS());
    _isAbsent[static_cast<std::size_t>(vehicle)] = true;
    motion(vehicle).setSpeed(0.0, timeS());
}

const std::vector<LaneSite>& ScenePerformer::laneSites()
{
    if (!_laneSites) _laneSites = simulation::laneSites(*_roads);
    return *_laneSites;
}

bool ScenePerformer::isDone(const ActionTicket& ticket) const
{
    if (ticket.entity < 0) return true;
    if (ticket.isRunningAction)
        return std::none_of(_running.begin(), _running.end(),
                            [&](const Running& running)
                            { return running.action && running.number == ticket.number; });
    return _motions[static_cast<std::size_t>(ticket.entity)].isDone(ticket.number, timeS());
}

void ScenePerformer::cancel(const ActionTicket& ticket)
{
    if (ticket.isRunningAction)
        for (Running& running : _running)
        {
            if (running.number == ticket.number) running.action.reset();
        }
    else if (ticket.entity >= 0)
        motion(ticket.entity).cancel(ticket.number, timeS());
}

} // namespace simulation
