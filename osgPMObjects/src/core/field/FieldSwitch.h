// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/selection/Switch.h>

#include "FieldSorter.h"

namespace osgPMObjects::core
{

/// advanceSwitch() on a ladder. A morph goes from rung to rung, as vertices have one target each, that of the rung on which
/// they vanish; where several rungs lie between, it goes as much faster.
DrawnLevels advanceOnLadder(SwitchState& state, std::uint32_t wanted, float stepS, float alpha,
                            std::uint32_t number, const SwitchSettings& settings);

/// Hands what is to be drawn of an object to the sorter. `eye`: in the field's units.
void showLevels(FieldSorter& sorter, const Field& field, std::uint32_t object, const DrawnLevels& levels,
                const glm::dvec3& eye);

} // namespace osgPMObjects::core
