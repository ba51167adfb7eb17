// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/StoryboardRunner.h"

#include <algorithm>

namespace simulation
{
namespace
{

using State = StoryboardElementState;
using Type = StoryboardElementType;

} // namespace

StoryboardRunner::StoryboardRunner(const Storyboard& storyboard, ActionPerformer& performer)
    : _storyboard(&storyboard), _performer(&performer)
{
    if (storyboard.stopTrigger) _stop.emplace(*storyboard.stopTrigger);
    for (const Story& story : storyboard.stories)
    {
        StoryRun run{_elements.add(Type::story, -1, story.name, story.source), {}};
        for (const Act& act : story.acts)
            run.acts.push_back(makeAct(act, run.element));
        _stories.push_back(std::move(run));
    }
}

StoryboardRunner::ActRun StoryboardRunner::makeAct(const Act& act, int story)
{
    ActRun run{_elements.add(Type::act, story, act.name, act.source), {}, {}, {}};
    if (act.startTrigger) run.start.emplace(*act.startTrigger);
    if (act.stopTrigger) run.stop.emplace(*act.stopTrigger);
    for (const ManeuverGroup& group : act.groups)
        run.groups.push_back(makeGroup(group, run.element));
    return run;
}

StoryboardRunner::GroupRun StoryboardRunner::makeGroup(const ManeuverGroup& group, int act)
{
    GroupRun run{&group, _elements.add(Type::maneuverGroup, act, group.name, group.source), 0, {}};
    for (const Maneuver& maneuver : group.maneuvers)
    {
        ManeuverRun maneuverRun{_elements.add(Type::maneuver, run.element, maneuver.name, maneuver.source),
                                {}};
        for (const Event& event : maneuver.events)
            maneuverRun.events.push_back(
                makeEvent(event, maneuverRun.element, group.selectTriggeringEntities));
        run.maneuvers.push_back(std::move(maneuverRun));
    }
    return run;
}

StoryboardRunner::EventRun StoryboardRunner::makeEvent(const Event& event, int maneuver, bool keepsEntities)
{
    EventRun run{&event, _elements.add(Type::event, maneuver, event.name, event.source), {}, {}, 0, {}};
    for (const NamedAction& action : event.actions)
        run.actionElements.push_back(_elements.add(Type::action, run.element, action.name, action.source));
    if (event.startTrigger) run.start.emplace(*event.startTrigger, keepsEntities);
    return run;
}

void StoryboardRunner::start(int element)
{
    _elements.set(element, State::runningState, State::startTransition);
}
void StoryboardRunner::end(int element)
{
    _elements.set(element, State::completeState, State::endTransition);
}

void StoryboardRunner::step(double timeS)
{
    if (_isFinished) return;
    _elements.beginStep(timeS);
    _facts.timeS = timeS;
    _facts.elementIs = [this](const StoryboardElementStateCondition& condition)
    { return _elements.is(condition); };
    if (_stop && _stop->update(_facts))
    {
        for (StoryRun& story : _stories)
            for (ActRun& act : story.acts)
                stopAct(act);
        _isFinished = true;
        return;
    }
    bool allComplete = true;
    for (StoryRun& story : _stories)
    {
        if (isIn(story.element, State::standbyState)) start(story.element);
        bool complete = true;
        for (ActRun& act : story.acts)
        {
            stepAct(act);
            complete = complete && isIn(act.element, State::completeState);
        }
        if (complete && !isIn(story.element, State::completeState)) end(story.element);
        allComplete = allComplete && complete;
    }
    const bool canStop = _storyboard->stopTrigger && !_storyboard->stopTrigger->groups.empty();
    if (allComplete && !canStop && !_stories.empty()) _isFinished = true;
}

void StoryboardRunner::stepAct(ActRun& act)
{
    if (isIn(act.element, State::completeState)) return;
    if (act.stop && act.stop->update(_facts))
    {
        stopAct(act);
        return;
    }
    if (isIn(act.element, State::standbyState))
    {
        if (act.start && !act.start->update(_facts)) return;
        start(act.element);
    }
    bool complete = true;
    for (GroupRun& group : act.groups)
    {
        stepGroup(group);
        complete = complete && isIn(group.element, State::completeState);
    }
    if (complete) end(act.element);
}

void StoryboardRunner::stepGroup(GroupRun& group)
{
    if (isIn(group.element, State::completeState)) return;
    if (isIn(group.element, State::standbyState))
    {
        start(group.element);
        for (ManeuverRun& maneuver : group.maneuvers)
        {
            start(maneuver.element);
            for (EventRun& event : maneuver.events)
            {
                event.executions = 0;
                if (event.start) event.start->reset();
                if (!isIn(event.element, State::standbyState))
                    _elements.set(event.element, State::standbyState, State::endTransition);
            }
        }
    }
    bool complete = true;
    for (ManeuverRun& maneuver : group.maneuvers)
    {
        if (!isIn(maneuver.element, State::completeState)) stepManeuver(maneuver, *group.group);
        complete = complete && isIn(maneuver.element, State::completeState);
    }
    if (!complete) return;
    ++group.executions;
    const bool again = group.executions < group.group->maximumExecutionCount && !group.maneuvers.empty();
    _elements.set(group.element, again ? State::standbyState : State::completeState, State::endTransition);
}

void StoryboardRunner::stepManeuver(ManeuverRun& maneuver, const ManeuverGroup& group)
{
    for (EventRun& event : maneuver.events)
        if (isIn(event.element, State::runningState)) stepRunningEvent(event);
    bool complete = true;
    for (EventRun& event : maneuver.events)
    {
        if (isIn(event.element, State::standbyState))
        {
            if (event.executions >= event.event->maximumExecutionCount)
                end(event.element);
            else if (!event.start || event.start->update(_facts))
                startEvent(event, maneuver, group);
        }
        complete = complete && isIn(event.element, State::completeState);
    }
    if (complete) end(maneuver.element);
}

void StoryboardRunner::startEvent(EventRun& event, ManeuverRun& maneuver, const ManeuverGroup& group)
{
    for (EventRun& other : maneuver.events)
    {
        if (!isIn(other.element, State::runningState)) continue;
        if (event.event->priority == Priority::skip)
        {
            _elements.skip(event.element);
            return;
        }
        if (event.event->priority == Priority::overwrite) stopEvent(other);
    }
    ++event.executions;
    start(event.element);
    event.actors = group.actors;
    if (group.selectTriggeringEntities && event.start)
        for (const std::string& entity : event.start->triggering())
            if (std::find(event.actors.begin(), event.actors.end(), entity) == event.actors.end())
                event.actors.push_back(entity);
    event.tickets.assign(event.event->actions.size(), {});
    for (std::size_t i = 0; i < event.tickets.size(); ++i)
    {
        start(event.actionElements[i]);
        const Action& action = event.event->actions[i].action;
        if (const auto* global = std::get_if<GlobalAction>(&action))
            _performer->perform(*global);
        else
            for (const std::string& actor : event.actors)
                event.tickets[i].push_back(_performer->perform(std::get<PrivateAction>(action), actor));
    }
}

void StoryboardRunner::stepRunningEvent(EventRun& event)
{
    bool complete = true;
    for (std::size_t i = 0; i < event.tickets.size(); ++i)
    {
        if (isIn(event.actionElements[i], State::completeState)) continue;
        const bool done =
            std::all_of(event.tickets[i].begin(), event.tickets[i].end(),
                        [this](const ActionTicket& ticket) { return _performer->isDone(ticket); });
        if (done) end(event.actionElements[i]);
        complete = complete && done;
    }
    if (!complete) return;
    const bool again = event.executions < event.event->maximumExecutionCount;
    if (again && event.start) event.start->reset();
    _elements.set(event.element, again ? State::standbyState : State::completeState, State::endTransition);
}

void StoryboardRunner::stopEvent(EventRun& event)
{
    for (std::size_t i = 0; i < event.tickets.size(); ++i)
    {
        if (isIn(event.actionElements[i], State::completeState)) continue;
        for (const ActionTicket& ticket : event.tickets[i])
            _performer->cancel(ticket);
        _elements.set(event.actionElements[i], State::completeState, State::stopTransition);
    }
    const bool again = event.executions < event.event->maximumExecutionCount;
    _elements.set(event.element, again ? State::standbyState : State::completeState, State::stopTransition);
}

void StoryboardRunner::stopAct(ActRun& act)
{
    for (GroupRun& group : act.groups)
        for (ManeuverRun& maneuver : group.maneuvers)
            for (EventRun& event : maneuver.events)
                if (isIn(event.element, State::runningState)) stopEvent(event);
    if (!isIn(act.element, State::completeState))
        _elements.set(act.element, State::completeState, State::stopTransition);
}

} // namespace simulation
