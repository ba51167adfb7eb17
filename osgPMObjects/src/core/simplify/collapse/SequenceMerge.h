// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <osgPMObjects/core/simplify/CollapseSequence.h>

#include "Collapser.h"
#include "UnitFrame.h"

namespace osgPMObjects::core
{

/// Merges the sequences of unconnected parts into one, in the order of one queue for all, and in frame and units of the mesh. One
/// queue would take the least urgent of the next steps of all parts. Steps that belong together (`goesOn`) stay together.
CollapseSequence mergedSequence(std::span<const PartialSequence> partial, const UnitFrame& frame,
                                std::uint32_t facesBefore);

} // namespace osgPMObjects::core
