// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgPMObjects/core/simplify/CollapseSequence.h>

namespace osgPMObjects::core
{

/// The first steps of a sequence alone.
CollapseSequence firstSteps(const CollapseSequence& sequence, std::size_t steps);

/// One sequence of a mesh from two: `second` is one of meshAfter(mesh, first, all its steps). Errors of the second count on top of
/// the first's last. When either has places, so has the result. Cost: linear in the mesh and the steps.
CollapseSequence joined(const Mesh& mesh, CollapseSequence first, const CollapseSequence& second);

} // namespace osgPMObjects::core
