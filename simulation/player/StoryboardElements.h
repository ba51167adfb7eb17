// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "simulation/scenario/Condition.h"
#include "simulation/scenario/SourceLine.h"

namespace simulation
{

/// An entry of the log: an element of the storyboard changed its state.
struct StoryboardLogEntry
{
    double timeS = 0.0;
    StoryboardElementType type = StoryboardElementType::event;
    std::string path; ///< names from the story down, `::` between them
    StoryboardElementState transition = StoryboardElementState::startTransition;
    int line = 0; ///< of the scenario's file

    bool operator==(const StoryboardLogEntry&) const = default;
};

/// The states of the elements of a storyboard. Conditions see a transition in the step in which it was made,
/// if they are evaluated later in it, and in the step after; they see a state at once.
class StoryboardElements
{
public:
    /// Adds an element in standby and returns its index.
    int add(StoryboardElementType type, int parent, const std::string& name, SourceLine source);

    /// Begins a step: the transitions of the last step become visible.
    void beginStep(double timeS);

    void set(int element, StoryboardElementState state, StoryboardElementState transition);

    /// Notes an event that did not start because another was running.
    void skip(int element) { note(element, StoryboardElementState::skipTransition); }

    StoryboardElementState state(int element) const
    {
        return _elements[static_cast<std::size_t>(element)].state;
    }

    /// Finds the element that a condition names, by its name or by the end of its path; -1 when there is
    /// none.
    int find(const StoryboardElementStateCondition& condition) const;

    bool is(const StoryboardElementStateCondition& condition) const;

    const std::vector<StoryboardLogEntry>& log() const { return _log; }

private:
    struct Element
    {
        StoryboardElementType type;
        std::string path;
        int line;
        StoryboardElementState state = StoryboardElementState::standbyState;
    };
    struct Transition
    {
        int element;
        StoryboardElementState transition;
    };

    void note(int element, StoryboardElementState transition);

    double _timeS = 0.0;
    std::vector<Element> _elements;
    std::map<std::pair<StoryboardElementType, std::string>, std::vector<int>> _byName;
    std::vector<Transition> _visible;
    std::vector<Transition> _made;
    std::vector<StoryboardLogEntry> _log;
};

} // namespace simulation
