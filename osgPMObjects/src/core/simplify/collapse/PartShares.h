// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "CollapseState.h"

namespace osgPMObjects::core
{

/// Divides the connected parts among threads, in shares of about as many faces each. Mirror images, and parts
/// that may join, are in one share; leaf cards are in none. There is at least one share, and none is empty
/// unless there are no parts.
std::vector<std::vector<std::uint32_t>> partShares(const CollapseState& state, std::size_t threads);

} // namespace osgPMObjects::core
