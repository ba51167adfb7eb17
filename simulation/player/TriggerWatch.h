// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "simulation/player/conditions/EntityConditions.h"
#include "simulation/scenario/Condition.h"

namespace simulation
{

/// The facts that conditions test, at one instant.
struct ConditionFacts
{
    double timeS = 0.0;
    std::function<bool(const StoryboardElementStateCondition&)> elementIs;
    EntityFacts entities{};
    const std::map<std::string, std::string>* values =
        nullptr; ///< of parameters, variables and what users name
    const std::map<std::string, std::string>* signals = nullptr; ///< states of traffic signals
    const std::map<std::string, std::string>* phases = nullptr;  ///< of the controllers of traffic signals
    std::optional<DateTime> dateTime{};
};

/// Evaluates one trigger from step to step. An edge compares a condition with the step before (the first
/// evaluation is no edge); a delay tests the condition, edge included, that long ago.
/// Memory: one entry for each change of a delayed condition within its delay.
/// Source: ASAM, *OpenSCENARIO XML* 1.3, "Conditions and triggers".
class TriggerWatch
{
public:
    /// `trigger` must outlive the watch.
    /// `keepsEntities`: triggering() is asked for.
    explicit TriggerWatch(const Trigger& trigger, bool keepsEntities = false);

    /// Evaluates the trigger. Call it once per step, in the order of time.
    bool update(const ConditionFacts& facts);

    /// The triggering entities of the last update(): those for which a condition of a group that fired held,
    /// when it held. One that waits for a falling edge has those for which it held last. In the order of the
    /// conditions, none twice.
    const std::vector<std::string>& triggering() const { return _triggering; }

    /// Clears the history.
    void reset();

private:
    struct Change
    {
        double timeS;
        bool value;
        std::vector<std::string> entities; ///< for which it held
    };
    struct Memory
    {
        bool hasLast = false;
        bool last = false;
        std::vector<std::string> entities;   ///< for which it held last
        std::vector<std::string> triggering; ///< of the last value
        std::deque<Change> changes; ///< the first may be older than the delay: it holds until the second
    };

    void addTriggering(std::size_t first, std::size_t last);
    bool updateCondition(const Condition& condition, Memory& memory, const ConditionFacts& facts);

    const Trigger* _trigger;
    bool _keepsEntities;
    std::vector<Memory> _memories; ///< of all conditions, group after group
    std::vector<std::string> _triggering;
};

} // namespace simulation
