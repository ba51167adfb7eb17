// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

namespace osgPMObjects::core
{

/// What players of a mesh have to hold at once.
struct PlayerNeeds
{
    std::uint32_t slotsOfStep = 0, rearrangements = 0, slotsMoved = 0;
};

/// Looks at everything but whether steps make sense: players of such a mesh stay inside all arrays, whatever the bytes. Empty: they
/// would not.
std::optional<PlayerNeeds> needsOf(const ProgressiveMesh& progressive);

} // namespace osgPMObjects::core
