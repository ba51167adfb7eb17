// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/scenario/Scenario.h"

namespace simulation
{

/// Calls `visit(const ManeuverGroup&, const Action&)` for every action of the stories with the group that it
/// stands in, in the file's order; those of Init are not among them.
template<class Visit>
void visitGroups(const Scenario& scenario, Visit visit)
{
    for (const Story& story : scenario.storyboard.stories)
        for (const Act& act : story.acts)
            for (const ManeuverGroup& group : act.groups)
                for (const Maneuver& maneuver : group.maneuvers)
                    for (const Event& event : maneuver.events)
                        for (const NamedAction& named : event.actions)
                            visit(group, named.action);
}

/// Calls `visit(const Action&)` for the same.
template<class Visit>
void visitActions(const Scenario& scenario, Visit visit)
{
    visitGroups(scenario, [&](const ManeuverGroup&, const Action& action) { visit(action); });
}

} // namespace simulation
