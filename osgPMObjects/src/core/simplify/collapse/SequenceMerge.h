// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <osgPMObjects/core/simplify/CollapseSequence.h>

#include "Collapser.h"
#include "UnitFrame.h"

namespace osgPMObjects::core
{

/// Puts the steps of parts that do not touch into the order in which one queue would have done them, and into the frame and the
/// units of the mesh. One queue would do the least urgent of all next steps, so this is a merge; steps that belong together stay so.
CollapseSequence mergedSequence(std::span<const PartialSequence> partial, const UnitFrame& frame,
                                std::uint32_t facesBefore);

} // namespace osgPMObjects::core
