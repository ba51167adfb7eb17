// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace osgPMObjects::core
{

/// A triangle, as the numbers of its three corners, counter-clockwise.
using Triangle = std::array<std::uint32_t, 3>;

/// Tells whether two corners are the same.
constexpr bool repeatsCorner(const Triangle& t)
{
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

} // namespace osgPMObjects::core
