// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/StoryboardElements.h"

#include <algorithm>

namespace simulation
{
namespace
{

constexpr std::size_t kMaximumLog =
    100'000; ///< a scenario that restarts an event in every step must not eat the memory

std::string lastName(const std::string& path)
{
    const std::size_t colons = path.rfind("::");
    return colons == std::string::npos ? path : path.substr(colons + 2);
}

bool endsWithName(const std::string& path, const std::string& name)
{
    if (path.size() == name.size()) return path == name;
    return path.size() > name.size() + 2 && path.ends_with(name) &&
           path.compare(path.size() - name.size() - 2, 2, "::") == 0;
}

} // namespace

int StoryboardElements::add(StoryboardElementType type, int parent, const std::string& name,
                            SourceLine source)
{
    const std::string path =
        parent < 0 ? name : _elements[static_cast<std::size_t>(parent)].path + "::" + name;
    _elements.push_back({type, path, source.line});
    const int index = static_cast<int>(_elements.size()) - 1;
    _byName[{type, lastName(name)}].push_back(index);
    return index;
}

void StoryboardElements::beginStep(double timeS)
{
    _timeS = timeS;
    _visible.swap(_made);
    _made.clear();
}

void StoryboardElements::set(int element, StoryboardElementState state, StoryboardElementState transition)
{
    _elements[static_cast<std::size_t>(element)].state = state;
    note(element, transition);
}

void StoryboardElements::note(int element, StoryboardElementState transition)
{
    _made.push_back({element, transition});
    const Element& changed = _elements[static_cast<std::size_t>(element)];
    if (_log.size() < kMaximumLog)
        _log.push_back({_timeS, changed.type, changed.path, transition, changed.line});
}

int StoryboardElements::find(const StoryboardElementStateCondition& condition) const
{
    const auto named = _byName.find({condition.type, lastName(condition.element)});
    if (named == _byName.end()) return -1;
    for (const int index : named->second)
        if (endsWithName(_elements[static_cast<std::size_t>(index)].path, condition.element)) return index;
    return -1;
}

bool StoryboardElements::is(const StoryboardElementStateCondition& condition) const
{
    const int element = find(condition);
    if (element < 0) return false;
    switch (condition.state)
    {
    case StoryboardElementState::standbyState:
    case StoryboardElementState::runningState:
    case StoryboardElementState::completeState:
        return state(element) == condition.state;
    default:
        break;
    }
    const auto isMeant = [&](const Transition& made)
    { return made.element == element && made.transition == condition.state; };
    return std::any_of(_visible.begin(), _visible.end(), isMeant) ||
           std::any_of(_made.begin(), _made.end(), isMeant);
}

} // namespace simulation
