// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/selection/Switch.h>

#include "FieldSorter.h"

namespace osgPMObjects::core
{

/// Advances a switch between rungs like advanceSwitch(). A morph goes from rung to rung, for each vertex has
/// one target only, on the rung on which it vanishes; a morph over several rungs is that much faster.
DrawnLevels advanceOnLadder(SwitchState& state, std::uint32_t wanted, float stepS, float alpha,
                            std::uint32_t number, const SwitchSettings& settings);

/// Adds what is to be drawn of an object to the sorter. `eye`: in the field's frame and units.
void showLevels(FieldSorter& sorter, const Field& field, std::uint32_t object, const DrawnLevels& levels,
                const glm::dvec3& eye);

} // namespace osgPMObjects::core
