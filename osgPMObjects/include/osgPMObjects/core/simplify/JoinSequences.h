// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <osgPMObjects/core/simplify/CollapseSequence.h>

namespace osgPMObjects::core
{

/// Returns the first `steps` steps of a sequence.
CollapseSequence firstSteps(const CollapseSequence& sequence, std::size_t steps);

/// Returns one sequence of `mesh` that plays `first` and then `second`. `second` is a sequence of the last
/// level of `first`. Errors of `second` are added to the last error of `first`. The result has places when
/// either has. Cost: linear in the mesh and the steps.
CollapseSequence joined(const Mesh& mesh, CollapseSequence first, const CollapseSequence& second);

} // namespace osgPMObjects::core
