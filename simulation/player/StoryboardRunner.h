// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "simulation/player/StoryboardElements.h"
#include "simulation/player/TriggerWatch.h"
#include "simulation/scenario/Storyboard.h"

namespace simulation
{

/// An action that has been started.
struct ActionTicket
{
    int entity = -1; ///< -1: done at once
    std::int64_t number = 0;
    bool isRunningAction = false; ///< whose number it is
};

/// The interface that performs the actions of the storyboard.
class ActionPerformer
{
public:
    virtual ~ActionPerformer() = default;
    virtual ActionTicket perform(const PrivateAction& action, const std::string& actor) = 0;
    virtual void perform(const GlobalAction& action) = 0;
    virtual bool isDone(const ActionTicket& ticket) const = 0;
    virtual void cancel(const ActionTicket& ticket) = 0;
};

/// Runs stories, acts, maneuver groups and events from step to step. An act starts by its trigger and ends
/// with its groups or by its stop trigger. An event starts by its trigger while its act runs, and ends with
/// its actions. An event ends no earlier than in the step after its start. Priorities and execution counts
/// follow the standard.
/// Source: ASAM, *OpenSCENARIO XML* 1.3, "Storyboard states".
class StoryboardRunner
{
public:
    /// `storyboard` must outlive the runner.
    StoryboardRunner(const Storyboard& storyboard, ActionPerformer& performer);

    void step(double timeS);

    /// What conditions ask, besides time and the storyboard: set before each step.
    ConditionFacts& facts() { return _facts; }

    /// Returns true after the stop trigger has fired, or when there is no stop trigger that can fire and all
    /// stories are over.
    bool isFinished() const { return _isFinished; }
    const StoryboardElements& elements() const { return _elements; }

private:
    struct EventRun
    {
        const Event* event;
        int element;
        std::vector<int> actionElements;
        std::optional<TriggerWatch> start;
        int executions = 0;
        std::vector<std::vector<ActionTicket>> tickets; ///< of each action, while the event runs
        std::vector<std::string> actors{};              ///< of this execution
    };
    struct ManeuverRun
    {
        int element;
        std::vector<EventRun> events;
    };
    struct GroupRun
    {
        const ManeuverGroup* group;
        int element;
        int executions = 0;
        std::vector<ManeuverRun> maneuvers;
    };
    struct ActRun
    {
        int element;
        std::optional<TriggerWatch> start;
        std::optional<TriggerWatch> stop;
        std::vector<GroupRun> groups;
    };
    struct StoryRun
    {
        int element;
        std::vector<ActRun> acts;
    };

    ActRun makeAct(const Act& act, int story);
    GroupRun makeGroup(const ManeuverGroup& group, int act);
    EventRun makeEvent(const Event& event, int maneuver, bool keepsEntities);

    void stepAct(ActRun& act);
    void stepGroup(GroupRun& group);
    void stepManeuver(ManeuverRun& maneuver, const ManeuverGroup& group);
    void stepRunningEvent(EventRun& event);
    void startEvent(EventRun& event, ManeuverRun& maneuver, const ManeuverGroup& group);
    void stopEvent(EventRun& event);
    void stopAct(ActRun& act);

    bool isIn(int element, StoryboardElementState state) const { return _elements.state(element) == state; }
    void start(int element);
    void end(int element);

    const Storyboard* _storyboard;
    ActionPerformer* _performer;
    StoryboardElements _elements;
    ConditionFacts _facts;
    std::vector<StoryRun> _stories;
    std::optional<TriggerWatch> _stop;
    bool _isFinished = false;
};

} // namespace simulation
