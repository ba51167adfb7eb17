// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace osgPMObjects::core
{

/// Returns the row of the coarsest drawable level that is no coarser than the wanted level, `steps`.
/// `drawable`: levels in steps, ascending from 0.
inline std::uint32_t drawableRowOf(std::span<const std::uint32_t> drawable, std::uint32_t steps)
{
    const auto next = std::upper_bound(drawable.begin(), drawable.end(), steps);
    return next == drawable.begin() ? 0 : static_cast<std::uint32_t>(next - drawable.begin()) - 1;
}

} // namespace osgPMObjects::core
