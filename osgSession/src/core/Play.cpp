// SPDX-License-Identifier: Apache-2.0
#include <osgSession/core/Play.h>

#include "PlayParts.h"
#include "SteppedScenario.h"
#include "simulation/parser/Keywords.h"
#include "simulation/track/LayRecordings.h"

namespace osgSession::core
{

namespace
{

Entity entityOf(const simulation::EntityState& state)
{
    return {state.name,     state.position, state.headingDeg, state.pitchDeg, state.rollDeg,
            state.velocity, state.speedMps, state.isOnGround, state.isPresent};
}

std::string wordOf(simulation::StoryboardElementState transition)
{
    for (const auto& [word, state] : simulation::kElementStates)
        if (state == transition) return std::string(word);
    return {};
}

} // namespace

Play::Play(std::unique_ptr<Parts> parts) : _parts(std::move(parts)) {}

Play::~Play() = default;

foundation::Result<std::unique_ptr<Play>> Play::open(const PlaySettings& settings)
{
    auto parts = std::make_unique<Parts>();
    auto scenario = readForPlay(settings, parts->notes);
    if (!scenario) return scenario.error();
    const auto laid = simulation::layRecordings(*scenario, {settings.scenario});
    if (!laid) return laid.error();
    parts->notes.insert(parts->notes.end(), laid->begin(), laid->end());
    const auto ground = openScenarioGround(*scenario, settings.scenario,
                                           settings.isWithoutRoads ? simulation::WithoutRoads::played
                                                                   : simulation::WithoutRoads::refused);
    if (!ground) return ground.error();
    if (ground->missing.roads) parts->notes.push_back(ground->missing.roads->message());
    auto driven = makeDriven(settings, *scenario, ground->wheels, ground->origin);
    if (!driven) return driven.error();
    parts->driven = std::move(*driven);
    auto player =
        makePlayer(std::move(*scenario), settings.scenario, *ground,
                   simulation::FixedClock(settings.stepsPerSecond), settings.seed, motionsOf(parts->driven));
    if (!player) return player.error();
    parts->owned = std::move(*player);
    parts->player = parts->owned.get();
    return std::make_unique<Play>(std::move(parts));
}

bool Play::step()
{
    if (isFinished()) return false;
    _parts->player->step();
    return true;
}

double Play::timeS() const
{
    return _parts->player->timeS();
}

double Play::stepS() const
{
    return _parts->player->clock().stepS();
}

bool Play::isFinished() const
{
    return _parts->player->isFinished();
}

std::vector<Entity> Play::entities() const
{
    std::vector<Entity> entities;
    for (const simulation::EntityState& state : _parts->player->entities())
        entities.push_back(entityOf(state));
    return entities;
}

foundation::Result<Entity> Play::entity(const std::string& name) const
{
    for (const simulation::EntityState& state : _parts->player->entities())
        if (state.name == name) return entityOf(state);
    return foundation::Error{name, "there is no entity of this name", "name one of entities()"};
}

std::vector<std::string> Play::inputs(const std::string& entity) const
{
    const auto driven = _parts->driven.find(entity);
    return driven == _parts->driven.end() ? std::vector<std::string>() : driven->second.inputs();
}

foundation::Outcome Play::set(const std::string& entity, const std::string& input, double value)
{
    const auto driven = _parts->driven.find(entity);
    if (driven == _parts->driven.end())
        return foundation::Error{entity, "the host does not drive it", "name it in PlaySettings::driven"};
    return driven->second.set(input, value);
}

std::vector<Event> Play::takeEvents()
{
    std::vector<Event> events;
    const auto& log = _parts->player->log();
    for (; _parts->eventsTaken < log.size(); ++_parts->eventsTaken)
    {
        const simulation::StoryboardLogEntry& entry = log[_parts->eventsTaken];
        events.push_back({entry.timeS, entry.path, wordOf(entry.transition)});
    }
    return events;
}

std::vector<std::string> Play::notes() const
{
    std::vector<std::string> notes = _parts->notes;
    for (const foundation::Error& warning : _parts->player->warnings())
        notes.push_back(warning.message());
    const std::vector<std::string> told = _parts->player->notes();
    notes.insert(notes.end(), told.begin(), told.end());
    return notes;
}

} // namespace osgSession::core
