// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

namespace osgPMObjects::core
{

/// The sizes of the buffers that a player of a mesh needs.
struct PlayerNeeds
{
    std::uint32_t slotsOfStep = 0, rearrangements = 0, slotsMoved = 0;
};

/// Checks that players of a mesh stay inside all arrays, whatever its bytes; it does not check that steps
/// make sense. Returns nothing if they would not.
std::optional<PlayerNeeds> needsOf(const ProgressiveMesh& progressive);

} // namespace osgPMObjects::core
