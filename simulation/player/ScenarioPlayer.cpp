// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/ScenarioPlayer.h"

#include <utility>

#include <foundation/Angle.h>

#include "simulation/player/ScenarioCheck.h"
#include "simulation/player/ScenePerformer.h"
#include "simulation/player/StoryboardRunner.h"
#include "simulation/vehicle/Airspeeds.h"
#include "simulation/vehicle/ScenarioWeather.h"

namespace simulation
{

/// Everything that moves: the player's inside.
class ScenarioPlayer::Stage
{
public:
    Stage(Scenario scenarioIn, PlayerOptions options)
        : scenario(std::move(scenarioIn)),
          traffic(scenario, options.seed),
          frame(options.origin, std::move(options.ground), std::move(options.projection)),
          clock(options.clock),
          _roads(std::move(options.roads)),
          _roadsUnder(_roads ? _roads : std::move(options.roadsUnder)),
          _environmentClock(options.origin, options.air),
          _performer({scenario, frame, _roads.get(), clock, _environmentClock, traffic, options.seed,
                      std::move(options.motionSource)}),
          _runner(scenario.storyboard, _performer)
    {
        for (const auto& [entity, motion] : options.motions)
            _performer.external().attach(static_cast<std::size_t>(scenario.entityIndex(entity)), motion);
        for (const auto& [entity, seat] : options.seats)
            _performer.external().seat(static_cast<std::size_t>(scenario.entityIndex(entity)), seat);
        _performer.performInit();
        begun = _performer.beginExternal();
        publish();
        look();
        _runner.step(clock.seconds());
        publish();
    }

    void step()
    {
        if (isFinished()) return;
        _performer.turn();
        clock.advance();
        _performer.carryOn();
        _performer.move();
        look();
        _runner.step(clock.seconds());
        // What triggers change shows with the next step on roads, as in esmini's tables.
        if (!_roads) states = _performer.states();
        findRoads();
        environment = _environmentClock.at(clock.seconds());
        findAirspeeds();
    }

    bool isFinished() const { return _runner.isFinished(); }
    bool areMotionsDone() const { return _performer.external().areDone(clock.seconds()); }
    const std::vector<EntityTold>& told() const { return _performer.external().told(); }
    std::vector<std::string> notes() const { return _performer.external().notes(); }
    const std::map<std::string, bool>& monitors() const { return _performer.monitors(); }
    const std::vector<StoryboardLogEntry>& log() const { return _runner.elements().log(); }
    const std::map<std::string, std::string>& signalStates() const { return _performer.signals().states(); }

    std::vector<foundation::Error> warnings;
    Scenario scenario;
    TrafficPlan traffic; ///< adds entities to the scenario, before anything counts them
    SceneFrame frame;
    FixedClock clock;
    foundation::Outcome begun = foundation::success(); ///< of the attached motions
    std::vector<EntityState> states;
    EnvironmentState environment;

private:
    /// Tells the conditions what there is.
    void look()
    {
        ConditionFacts& facts = _runner.facts();
        states = _performer.states();
        facts.entities = {&scenario,      &states, &_lasting, _roads.get(), &_performer.positions(),
                          clock.seconds()};
        updateLasting(facts.entities, _lasting);
        facts.values = &_performer.values();
        facts.signals = &_performer.signals().states();
        facts.phases = &_performer.signals().phases();
        facts.dateTime = _environmentClock.at(clock.seconds()).dateTime;
    }

    /// Finds the road under each entity, for tables: conditions do not ask.
    void findRoads()
    {
        if (!_roadsUnder) return;
        for (EntityState& state : states)
        {
            if (!_roads)
                state.laneUnder =
                    _roadsUnder->nearest(state.position, foundation::radiansOf(state.headingDeg));
            if (state.laneUnder && state.laneUnder->road >= 0)
                state.roadUnder = _roadsUnder->roadAt(*state.laneUnder).id;
        }
    }

    /// Finds how fast aircraft without physics go through the air, for tables, where the scenario says how
    /// that moves.
    void findAirspeeds()
    {
        if (!environment.wind) return;
        const auto& local = frame.frame();
        const WeatherAir air(weatherOf(environment, local ? local->origin().heightM : 0.0));
        for (std::size_t i = 0; i < states.size(); ++i)
        {
            EntityState& state = states[i];
            if (state.readings || !state.isPresent || !scenario.entities[i].isAirborne()) continue;
            const double heightM =
                local ? local->geodeticFromLocal(state.position).heightM : state.position.z;
            const AirSample here = air.at(state.position, heightM, clock.seconds());
            state.readings.emplace().condition = "";
            writeAirspeed(glm::length(state.velocity - here.windMps), here, state);
        }
    }

    void publish()
    {
        states = _performer.states();
        findRoads();
        environment = _environmentClock.at(clock.seconds());
        findAirspeeds();
    }

    std::shared_ptr<const RoadScene> _roads, _roadsUnder;
    EnvironmentClock _environmentClock;
    ScenePerformer _performer;
    StoryboardRunner _runner;
    std::vector<LastingFacts> _lasting;
};

foundation::Result<std::unique_ptr<ScenarioPlayer>> ScenarioPlayer::create(Scenario scenario,
                                                                           PlayerOptions options)
{
    const auto line = options.roads ? std::nullopt : scenario.placesOnRoads();
    const std::string& logicFile = scenario.roadNetwork.logicFile;
    if (line)
        return foundation::Error{options.scenarioName + ":" + std::to_string(line->line),
                                 "a place on a road, but " +
                                     (logicFile.empty() ? "RoadNetwork names no LogicFile"
                                                        : "the LogicFile " + logicFile + " is not there"),
                                 "name the OpenDRIVE file there"};
    const SceneFrame frame(options.origin, options.ground, options.projection);
    auto warnings = checkPlayable(scenario, frame, options.scenarioName, options.roads.get());
    if (!warnings) return warnings.error();
    if (options.motionSource)
        if (auto usable = checkControllers(scenario, *options.motionSource, options.scenarioName); !usable)
            return usable.error();
    for (const auto& [entity, motion] : options.motions)
        if (scenario.entityIndex(entity) < 0)
            return foundation::Error{options.scenarioName, "there is no entity '" + entity + "' to move",
                                     "name one of Entities"};
    for (const auto& [entity, seat] : options.seats)
        if (scenario.entityIndex(entity) < 0)
            return foundation::Error{options.scenarioName, "there is no entity '" + entity + "' to sit in",
                                     "name one of Entities"};
    std::unique_ptr<ScenarioPlayer> player(new ScenarioPlayer(std::move(scenario), std::move(options)));
    if (const auto& begun = player->_stage->begun; !begun) return begun.error();
    player->_stage->warnings = std::move(*warnings);
    return player;
}

ScenarioPlayer::ScenarioPlayer(Scenario scenario, PlayerOptions options)
    : _stage(std::make_unique<Stage>(std::move(scenario), std::move(options)))
{
}

ScenarioPlayer::~ScenarioPlayer() = default;

void ScenarioPlayer::step()
{
    _stage->step();
}
double ScenarioPlayer::timeS() const
{
    return _stage->clock.seconds();
}
const FixedClock& ScenarioPlayer::clock() const
{
    return _stage->clock;
}
const Scenario& ScenarioPlayer::scenario() const
{
    return _stage->scenario;
}
const std::vector<EntityState>& ScenarioPlayer::entities() const
{
    return _stage->states;
}
const EnvironmentState& ScenarioPlayer::environment() const
{
    return _stage->environment;
}
const std::map<std::string, std::string>& ScenarioPlayer::signalStates() const
{
    return _stage->signalStates();
}
const std::vector<StoryboardLogEntry>& ScenarioPlayer::log() const
{
    return _stage->log();
}
const std::map<std::string, bool>& ScenarioPlayer::monitors() const
{
    return _stage->monitors();
}
std::vector<std::string> ScenarioPlayer::notes() const
{
    return _stage->notes();
}
const std::vector<foundation::Error>& ScenarioPlayer::warnings() const
{
    return _stage->warnings;
}
bool ScenarioPlayer::areMotionsDone() const
{
    return _stage->areMotionsDone();
}
const std::vector<EntityTold>& ScenarioPlayer::told() const
{
    return _stage->told();
}
bool ScenarioPlayer::isFinished() const
{
    return _stage->isFinished();
}

} // namespace simulation
