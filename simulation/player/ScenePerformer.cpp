// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/ScenePerformer.h"

#include <algorithm>
#include <cmath>

#include "simulation/player/EntityDistance.h"
#include "simulation/player/way/JunctionKeeper.h"
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
      _external({place.scenario, _actors, [this] { return _environment->at(timeS()); },
                 [](const EntityMotion& motion) { return motion.wayAhead(kWayM); }},
                place.motionSource),
      _positions(place.frame, place.roads,
                 [this](const std::string& entity) -> const EntityState*
                 {
                     const int index = find(entity);
                     return index < 0 ? nullptr : &motion(index).state();
                 }),
      _signals(place.scenario.roadNetwork.signalControllers),
      _trailers(place.scenario),
      _traffic(place.traffic, place.seed)
{
    const Scenario& scenario = place.scenario;
    const std::vector<bool> absent = absentAtFirst(scenario);
    _actors.reserve(scenario.entities.size());
    for (std::size_t i = 0; i < scenario.entities.size(); ++i)
    {
        const ScenarioObject& object = scenario.entities[i];
        _actors.emplace_back(object, place.frame, place.roads);
        _actors.back().isAbsent = absent[i] || isTraffic(static_cast<int>(i));
        _boxes.push_back(object.box());
        _reachesM.push_back(reachOf(object.box()));
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
    _trailers.align(_actors);
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
    for (Actor& actor : _actors)
        if (!actor.mover() && !actor.isAbsent) actor.motion.advanceTo(timeS(), _clock->stepS());
    moveControlled();
    moveExternal();
    for (Actor& actor : _actors)
        if (actor.givenBack && actor.givenBack->isOver(timeS())) actor.givenBack.reset();
    _trailers.follow(_actors);
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
    for (std::size_t i = 0; i < _actors.size(); ++i)
    {
        const Actor& actor = _actors[i];
        if (!actor.isExternal() && actor.mover() && !actor.isAbsent)
            actor.mover()->move(*this, static_cast<int>(i));
    }
}

/// All see the others as they were before.
void ScenePerformer::moveExternal()
{
    _environmentNow = _environment->at(timeS());
    for (std::size_t i = 0; i < _actors.size(); ++i)
    {
        if (!_actors[i].isExternal()) continue;
        askExternal(i);
        _actors[i].mover()->move(*this, static_cast<int>(i));
    }
    _external.tell();
}

/// What the scenario wants in the domain that is not the vehicle's own.
void ScenePerformer::askExternal(std::size_t entity)
{
    const Actor& actor = _actors[entity];
    if (!actor.vehicle.isLongitudinal) actor.mover()->askForSpeed(actor.motion.askedSpeedAt(timeS()));
    if (actor.vehicle.isLateral) return;
    if (const auto place = askedPlace(entity)) actor.mover()->askForPlace(place);
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
    const EntityState& state = _actors[entity].motion.state();
    if (!isMoved || !_roads || !state.place) return std::nullopt;
    return _roads->poseAt(*state.place).position;
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
    const std::vector<EntityState> before = std::move(_published);
    _published.clear();
    _published.reserve(_actors.size());
    for (const Actor& actor : _actors)
        _published.push_back(actor.motion.state());
    leadGivenBack();
    for (std::size_t i = 0; i < _published.size(); ++i)
    {
        Actor& actor = _actors[i];
        EntityState& state = _published[i];
        state.isPresent = !actor.isAbsent;
        state.laneUnder = laneUnder(state);
        state.isVisible = !actor.isAbsent && !actor.isHidden;
        for (auto& [name, lamp] : actor.lamps)
        {
            const double period = lamp.onS + lamp.offS;
            const double since = timeS() - lamp.sinceS;
            lamp.isLit = lamp.mode == LightMode::on ||
                         (lamp.mode == LightMode::flashing &&
                          (period <= 0.0 || std::fmod(since + kInstantS, period) < lamp.onS));
        }
        for (const auto& [name, lamp] : actor.lamps) // over those of its own physics
            state.lamps[name] = lamp;
    }
    for (std::size_t i = 0; i < _published.size() && i < before.size(); ++i)
        _published[i].acceleration = (_published[i].velocity - before[i].velocity) / _clock->stepS();
    collide();
}

void ScenePerformer::collide()
{
    const auto body = [&](std::size_t index) { return MeasuredBody{&_published[index], _boxes[index]}; };
    const auto areNear = [&](std::size_t i, std::size_t j)
    {
        const glm::dvec2 apart(_published[j].position - _published[i].position);
        const double reach = _reachesM[i] + _reachesM[j];
        return apart.x * apart.x + apart.y * apart.y <= reach * reach;
    };
    for (std::size_t i = 0; i < _published.size(); ++i)
        for (std::size_t j = i + 1; !_actors[i].isAbsent && j < _published.size(); ++j)
            if (!_actors[j].isAbsent && areNear(i, j) && overlap(body(i), body(j)))
            {
                _published[i].collidesWith.push_back(static_cast<int>(j));
                _published[j].collidesWith.push_back(static_cast<int>(i));
            }
    // A body that was kept out of a box touches it all the same.
    const auto meet = [this](int one, int other)
    {
        std::vector<int>& met = _published[static_cast<std::size_t>(one)].collidesWith;
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
    if (actor < 0 || actorOf(actor).isAbsent || isHeld(action, actor)) return {};
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
    actorOf(vehicle).isAbsent = false;
    activate("", {true, true}, vehicle);
}

void ScenePerformer::vanish(int vehicle)
{
    for (const ActionDomain domain : {ActionDomain::longitudinal, ActionDomain::lateral})
        end(vehicle, domain);
    actorOf(vehicle).speed.reset();
    _external.vanish(static_cast<std::size_t>(vehicle), timeS());
    actorOf(vehicle).isAbsent = true;
    motion(vehicle).setSpeed(0.0, timeS());
}

std::shared_ptr<JunctionKeeper> ScenePerformer::junctions()
{
    if (!_junctions && _roads) _junctions = std::make_shared<JunctionKeeper>(*_roads);
    return _junctions;
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
    return _actors[static_cast<std::size_t>(ticket.entity)].motion.isDone(ticket.number, timeS());
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
