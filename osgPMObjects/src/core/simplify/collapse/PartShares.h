// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "CollapseState.h"

namespace osgPMObjects::core
{

/// Part numbers in shares for so many threads, of about as many faces each. Parts that have to do with each other, as mirror
/// images or as neighbours that may join, are in one share. Without those that are leaves. At least one share, none empty unless there are no parts.
std::vector<std::vector<std::uint32_t>> partShares(const CollapseState& state, std::size_t threads);

} // namespace osgPMObjects::core
