// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/Mesh.h>
#include <osgPMObjects/core/simplify/CollapseSequence.h>

#include "WedgePlan.h"

namespace osgPMObjects::core
{

/// Appends a step to a sequence; its wedges are those that are appended after it. `place`: the remaining
/// position after the step, null when positions do not move.
void appendStep(CollapseSequence& sequence, CollapseStep step, const glm::dvec3* place);

/// Appends the wedges of the last step of a sequence, as planned. `moved`: the mesh whose wedges get their
/// new attributes; null when the plan moves nothing.
void appendWedges(CollapseSequence& sequence, const WedgePlan& plan, Mesh* moved);

} // namespace osgPMObjects::core
