// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace osgPMObjects::core
{

/// The row of levels that can be drawn which a wanted level is drawn by: the coarsest that is no coarser.
/// `drawn`: in steps, ascending from 0.
inline std::uint32_t drawnRowOf(std::span<const std::uint32_t> drawn, std::uint32_t steps)
{
    const auto next = std::upper_bound(drawn.begin(), drawn.end(), steps);
    return next == drawn.begin() ? 0 : static_cast<std::uint32_t>(next - drawn.begin()) - 1;
}

} // namespace osgPMObjects::core
