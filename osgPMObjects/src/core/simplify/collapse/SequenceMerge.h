// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <osgPMObjects/core/simplify/CollapseSequence.h>

#include "Collapser.h"
#include "UnitFrame.h"

namespace osgPMObjects::core
{

/// Merges the sequences of unconnected parts into one, as if all parts had shared one queue: the next step is
/// the one with the least Urgency among the next steps of all parts. Steps that belong together (`goesOn`)
/// stay together. `frame`: in which the parts were collapsed; the result is in frame and units of the mesh.
/// `facesBefore`: faces of the mesh.
CollapseSequence mergedSequence(std::span<const PartialSequence> partial, const UnitFrame& frame,
                                std::uint32_t facesBefore);

} // namespace osgPMObjects::core
