// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/Scenario.h"

#include <algorithm>

namespace simulation
{

int Scenario::entityIndex(const std::string& name) const
{
    const auto found = std::find_if(entities.begin(), entities.end(),
                                    [&](const ScenarioObject& object) { return object.name == name; });
    return found == entities.end() ? -1 : static_cast<int>(found - entities.begin());
}

bool Scenario::isConsistent() const
{
    const auto known = [this](const std::string& name) { return entityIndex(name) >= 0; };
    for (const InitPrivate& initial : storyboard.init.privates)
        if (!known(initial.entity)) return false;
    for (const Story& story : storyboard.stories)
        for (const Act& act : story.acts)
            for (const ManeuverGroup& group : act.groups)
                if (!std::all_of(group.actors.begin(), group.actors.end(), known)) return false;
    return true;
}

} // namespace simulation
