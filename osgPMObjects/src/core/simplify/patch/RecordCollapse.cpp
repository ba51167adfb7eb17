// SPDX-License-Identifier: Apache-2.0
#include "RecordCollapse.h"

#include <osgPMObjects/core/mesh/Wedge.h>

namespace osgPMObjects::core
{

void appendStep(CollapseSequence& sequence, CollapseStep step, const glm::dvec3* place)
{
    step.firstWedge = static_cast<std::uint32_t>(sequence.wedges.size());
    step.firstMoved = static_cast<std::uint32_t>(sequence.movedWedges.size());
    sequence.steps.push_back(step);
    if (place != nullptr) sequence.places.push_back(*place);
}

void appendWedges(CollapseSequence& sequence, const WedgePlan& plan, Mesh* moved)
{
    const auto move = [&](const WedgeChange& change)
    {
        Wedge attributes = change.attributes;
        attributes.position = sequence.steps.back().to;
        sequence.movedWedges.push_back({change.becomes, attributes});
        assignWedge(*moved, change.becomes, attributes);
    };
    for (const WedgeChange& change : plan.ofFrom())
        if (change.becomes != change.wedge)
            sequence.wedges.push_back({change.wedge, change.becomes});
        else
            move(change);
    for (const WedgeChange& change : plan.ofTo())
        move(change);
}

} // namespace osgPMObjects::core
