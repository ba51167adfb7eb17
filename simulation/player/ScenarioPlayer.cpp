// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/ScenarioPlayer.h"

#include <utility>

#include "simulation/player/EntityMotion.h"
#include "simulation/player/ScenarioCheck.h"
#include "simulation/player/StoryboardRunner.h"

namespace simulation
{

/// Everything that moves: the player's inside, and the performer of the storyboard's actions.
class ScenarioPlayer::Stage final : public ActionPerformer
{
public:
    Stage(Scenario scenarioIn, PlayerOptions options)
        : scenario(std::move(scenarioIn)),
          frame(options.origin, std::move(options.ground)),
          clock(options.clock),
          _environmentClock(options.origin),
          _runner(scenario.storyboard, *this)
    {
        for (const ScenarioObject& object : scenario.entities)
            _motions.emplace_back(object, frame);
        for (const GlobalAction& action : scenario.storyboard.init.globals)
            perform(action);
        for (const InitPrivate& initial : scenario.storyboard.init.privates)
            for (const PrivateAction& action : initial.actions)
                perform(action, initial.entity);
        _runner.step(clock.seconds());
        publish();
    }

    void step()
    {
        if (isFinished()) return;
        clock.advance();
        for (EntityMotion& motion : _motions)
            motion.advanceTo(clock.seconds());
        _runner.step(clock.seconds());
        publish();
    }

    bool isFinished() const { return _runner.isFinished(); }
    const std::vector<StoryboardLogEntry>& log() const { return _runner.elements().log(); }

    ActionTicket perform(const PrivateAction& action, const std::string& actor) override
    {
        const int entity = scenario.entityIndex(actor);
        if (entity < 0) return {};
        EntityMotion& motion = _motions[static_cast<std::size_t>(entity)];
        const double now = clock.seconds();
        if (const auto* teleport = std::get_if<TeleportAction>(&action))
        {
            if (frame.canPlace(teleport->position)) motion.teleport(teleport->position, now);
            return {};
        }
        if (const auto* speed = std::get_if<SpeedAction>(&action))
            return {entity, motion.startSpeed(*speed, now)};
        const auto* follow = std::get_if<FollowTrajectoryAction>(&action);
        if (!follow || TrajectoryRun::obstacle(*follow, frame)) return {};
        return {entity, motion.startTrajectory(*follow, now)};
    }

    void perform(const GlobalAction& action) override
    {
        if (const auto* content = std::get_if<EnvironmentAction>(&action))
            _environmentClock.apply(content->environment, clock.seconds());
    }

    bool isDone(const ActionTicket& ticket) const override
    {
        return ticket.entity < 0 ||
               _motions[static_cast<std::size_t>(ticket.entity)].isDone(ticket.number, clock.seconds());
    }

    void cancel(const ActionTicket& ticket) override
    {
        if (ticket.entity >= 0)
            _motions[static_cast<std::size_t>(ticket.entity)].cancel(ticket.number, clock.seconds());
    }

    Scenario scenario;
    SceneFrame frame;
    FixedClock clock;
    std::vector<EntityState> states;
    EnvironmentState environment;

private:
    void publish()
    {
        states.clear();
        for (const EntityMotion& motion : _motions)
            states.push_back(motion.state());
        environment = _environmentClock.at(clock.seconds());
    }

    EnvironmentClock _environmentClock;
    std::vector<EntityMotion> _motions;
    StoryboardRunner _runner;
};

foundation::Result<std::unique_ptr<ScenarioPlayer>> ScenarioPlayer::create(Scenario scenario,
                                                                           PlayerOptions options)
{
    const SceneFrame frame(options.origin, options.ground);
    if (foundation::Outcome playable = checkPlayable(scenario, frame, options.scenarioName); !playable)
        return playable.error();
    return std::unique_ptr<ScenarioPlayer>(new ScenarioPlayer(std::move(scenario), std::move(options)));
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
const std::vector<StoryboardLogEntry>& ScenarioPlayer::log() const
{
    return _stage->log();
}
bool ScenarioPlayer::isFinished() const
{
    return _stage->isFinished();
}

} // namespace simulation
